// SPDX-License-Identifier: MIT

// node comparison_test.mjs MICROSLIP FOLDER: the report of a campaign, and of tests against a model alone, in a
// browser: the verdict of the first screen on the predictions, the tables and figures of both sections, on a desk and on
// a phone. Pictures are left in FOLDER.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname} from 'node:path';
import {fileURLToPath} from 'node:url';
import * as tools from './browser.mjs';

const [program, path] = process.argv.slice(2);
const browser = await tools.launch();
rmSync(path, {recursive: true, force: true});
const artefacts = tools.folder(path);
const run = (...args) => execFileSync(program, [...args, '--quiet'], {cwd: artefacts, stdio: 'inherit'});
const put = (name, text) => writeFileSync(`${artefacts}/${name}`, text);

put('joint.json', `{"schema": "microslip.joint/1", "stiffness_N_per_m": 4e5, "density": [{"type": "power_law",
  "coefficient": 0.0002, "exponent": 0.2, "from_N": 0, "to_N": 150}]}\n`);
put('rig.toml', `schema = "microslip.rig/1"
[modes]
frequency_Hz = [80.0]
excitation = [0.7]
joint = [0.7]
[damping]
loss_factor = [0.002]
[excitation]
channel = "force"
[[accelerometer]]
channel = "acceleration"
shape = [0.7]
`);
run('model', 'rig.toml', 'joint.json', '--out', 'true.toml');

let seed = 5;
/** Even, of standard deviation 1. */
const noise = () => { seed = (seed * 48271) % 2147483647; return Math.sqrt(12) * (seed / 2147483647 - 0.5); };

/** A sweep at a response, µm, whose force is read with a gain. */
function sweep(name, response, gain = 1) {
  run('frf', 'true.toml', '--response', `${response}um`, '--frequency', '78.5:80.8', '--at', '78.5:80.8:41', '--out', 'f.csv');
  const rows = readFileSync(`${artefacts}/f.csv`, 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
  const names = rows.shift().split(',').map((column) => column.split(' ')[0]);
  const cell = (row, column) => Number(row[names.indexOf(column)]);
  const lines = rows.map((line) => line.split(',')).map((row) => [cell(row, 'frequency'),
    gain * cell(row, 'force') * (1 + 0.004 * noise()), cell(row, 'acceleration') * (1 + 0.002 * noise()),
    Math.PI - cell(row, 'phase')].join(','));
  put(name, `frequency [Hz],force [N],acceleration [m/s^2],phase [rad]\n${lines.join('\n')}\n`);
}

/** A test of the campaign. */
const test = (name, use, session) => `[[test]]\nname = "${name}"\nfile = "${name}.csv"\nuse = "${use}"\nsession = "${session}"\n`;
let campaign = `schema = "microslip.campaign/1"
structure = "rig.toml"
[identification]
stiffness_N_per_m = 4e5
draws = 200
leave_one_out = "tests"
[prediction]
force_gain_std = 0.02
`;
for (const session of ['monday', 'friday']) {
  const names = [20, 40, 60, 90, 130, 180, 250].map((response) => `${session}_${response}.csv`);
  for (const name of names) sweep(name, Number(name.match(/\d+/)[0]));
  run('reduce', 'rig.toml', ...names, '--out', `${session}.csv`);
  campaign += `${test(session, 'identify', session)}conditions = {torque_Nm = ${session === 'monday' ? 12 : 20}}\n`;
}
sweep('middle.csv', 100);
sweep('strange.csv', 150, 1.15);  // its force is read 15 % too high
put('campaign.toml', campaign + test('middle', 'predict', 'monday') + test('strange', 'predict', 'monday'));
run('campaign', 'campaign.toml', '--out', 'found');
run('report', 'found', '--out', 'found.html');

const found = `${artefacts}/found.html`;
const bytes = tools.checkSize(found);
const opened = await tools.open(browser, found);
const {page, faults} = opened;
await tools.takePictures(browser, found, artefacts, ['few_inside'], {opened});
await tools.checkEveryFigure(page);
const reach = await page.locator('dt:text-is("predictions against tests") + dd').textContent();
assert.match(reach, /^\d+ of \d+ values of 2 tests inside their bands/);
assert.match(reach, /Against it: .*few_inside/);
assert.doesNotMatch(await page.locator('body').textContent(), /compared with no record|no verification\.csv/);
const row = (table, text) => page.locator('.table-block', {hasText: table}).locator('tbody tr', {hasText: text});
for (const [quantity, verdict] of [['force', 'outside'], ['frequency', 'inside'], ['damping ratio', 'outside']]) {
  const shown = row('Measured and predicted values', 'strange.csv').filter({hasText: quantity});
  assert.match(await shown.textContent(), new RegExp(`${verdict}$`), quantity);
  assert.equal(await shown.evaluate((node) => node.classList.contains('marked')), verdict === 'outside', quantity);
}
assert.equal(await page.locator('.table-block', {hasText: 'Tests as a whole'}).locator('tr.marked').count(), 1);
assert.match(await row('Tests of the campaign', 'monday').first().textContent(), /^mondayidentifymondaytorque 12 Nm7/);
assert.equal(await row('Sessions', 'friday').count() > 0, true);
// Both days are of one joint: D of 20 Nm is that of 12 Nm within its noise.
assert.match(await row('Levels by the conditions of their tests', 'torque [Nm]').nth(1).textContent(), /^torque \[Nm\]2017/);
const torque = await row('Effect of conditions', 'torque [Nm]').textContent();
assert.match(torque, /^torque \[Nm\]D [+-][\d.e-]+ ± [\d.e-]+ %, frequency .* per Nm of torqueyesD at 20 differs by .* from that at 12; the frequency/);
assert.equal(await page.locator('.table-block', {hasText: 'Left out'}).first().locator('tbody tr').count(), 2);
const force = tools.figure(page, 'Measured and predicted force');
assert.deepEqual(await force.locator('option').allTextContents(), ['middle.csv', 'strange.csv']);
await force.locator('select').selectOption('strange.csv');
assert.match(await force.locator('.legend').textContent(), /measured, outside/);
assert.deepEqual(faults, []);

// Two joints from modes of two days: sessions by mode, and the test of a mode that was read 10 % too high.
const example = `${dirname(fileURLToPath(import.meta.url))}/../../examples/two_joints`;
const levels = readFileSync(`${example}/levels.csv`, 'utf8').split('\n').filter((line) => line && !line.startsWith('#'));
const head = levels.shift();
let joints = `schema = "microslip.campaign/1"
model = "unknown.toml"
[identification]
draws = 100
session_offsets = true
leave_one_out = "tests"
`;
put('unknown.toml', readFileSync(`${example}/unknown.toml`, 'utf8'));
for (const [day, session] of ['monday', 'friday', 'sunday'].entries()) {
  for (const mode of ['1', '2']) {
    const rows = levels.filter((line, i) => line.startsWith(`${mode},`) && i % 6 === day);
    const wrong = session === 'sunday' && mode === '2';
    const read = rows.map((line) => line.split(',')).map((cells) => [...cells.slice(0, 3), wrong ? 1.1 * cells[3] : cells[3]].join(','));
    put(`${session}${mode}.csv`, [head, ...read, ''].join('\n'));
    joints += test(`${session}${mode}`, 'identify', session);
  }
}
put('joints.toml', joints);
run('campaign', 'joints.toml', '--out', 'jointed');
run('report', 'jointed', '--out', 'jointed.html');
const several = await tools.open(browser, `${artefacts}/jointed.html`);
await tools.takePictures(browser, `${artefacts}/jointed.html`, tools.folder(`${artefacts}/several`), ['left_out_contradicts'],
    {opened: several});
await tools.checkEveryFigure(several.page);
const shown = (title) => several.page.locator('.table-block', {hasText: title}).first().locator('tbody tr');
assert.equal(await shown('Frequencies against the first session').count(), 6);
assert.match(await shown('Frequencies against the first session').nth(3).textContent(), /^friday21/);
assert.deepEqual(await shown('Each left out in turn').filter({hasText: /yes$/}).locator('td:first-child').allTextContents(), ['sunday2']);
assert.match(await several.page.locator('.verdict').textContent(), /1 of 6 tests contradicts the others, .*: sunday2, D \+/);
assert.match(await several.page.locator('body').textContent(), /26 modal levels of 6 tests identify its joints, in 3 sessions/);
assert.deepEqual(several.faults, []);

// A comparison by itself, without draws: no bands, as the report states.
tools.folder(`${artefacts}/compared`);
run('verify', 'true.toml', 'middle.csv', '--out', 'compared/comparison.csv');
run('report', 'compared', '--out', 'compared.html');
const alone = await tools.open(browser, `${artefacts}/compared.html`);
await tools.takePictures(browser, `${artefacts}/compared.html`, tools.folder(`${artefacts}/alone`), [], {opened: alone});
await tools.checkEveryFigure(alone.page);
assert.match(await alone.page.locator('.verdict').textContent(), /1 test, without bands to assess them/);
assert.doesNotMatch(await alone.page.locator('body').textContent(), /No joint\.json/);
assert.deepEqual(alone.faults, []);
await browser.close();
console.log(`measured: ${JSON.stringify({bytes})}`);
console.log('ok');
