// SPDX-License-Identifier: MIT

// node folder_test.mjs MICROSLIP EXAMPLES FOLDER: reports of folders that lack something, in a browser:
// levels alone; then levels and a joint reduced and identified from the recordings of
// examples/reference_rig; then a recording with hostile names. Pictures are left in FOLDER.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {cpSync, existsSync, rmSync, writeFileSync} from 'node:fs';
import * as tools from './browser.mjs';

const [program, examples, path] = process.argv.slice(2);
const browser = await tools.launch();
rmSync(path, {recursive: true, force: true});
const artefacts = tools.folder(path);
const test = tools.folder(`${artefacts}/test`);
const file = `${artefacts}/report.html`;
const run = (...args) => execFileSync(program, [...args, '--quiet'], {cwd: test, stdio: 'inherit'});

cpSync(`${examples}/reference_rig`, test, {recursive: true});
cpSync(`${examples}/reference_joint/joint.json`, `${test}/truth_joint.json`);
rmSync(`${test}/joint.json`, {force: true}); // was written by hand: identify would not replace it
const records = Array.from({length: 12}, (_, i) => `recordings/level_${String(i + 1).padStart(2, '0')}.csv`);
run('reduce', 'rig.toml', ...records, '--out', 'levels.csv');
run('identify', 'levels.csv', '--stiffness', '1.7e5', '--bands', '100', '--out', 'joint.json',
    '--density-csv', 'density.csv');
run('report', '.', '--title', 'Reference rig', '--out', file);

const bytes = tools.checkSize(file);
const opened = await tools.open(browser, file);
const {page, faults} = opened;
await tools.takePictures(browser, file, artefacts, undefined, {opened});
await tools.checkEveryFigure(page);
const titles = await page.locator('figure h3').allTextContents();
for (const title of ['Force over time', 'Acceleration over time', 'Displacement over time', 'Harmonics',
  'Energies per cycle', 'Residuals of D', 'Standardised residuals', 'Slip-force density',
  'Slope of the dissipation', 'Path of the smoothing parameter', 'Density along the path',
  'Regenerated loops', 'Difference to the identified joint', 'Resonance frequency', 'Secant stiffness',
  'Loss factor of the joint', 'Damping of the structure', 'Frequency responses at constant response']) {
  assert.ok(titles.includes(title), `${title} is missing in ${titles.join(', ')}`);
}

const traces = async (title) => tools.plotted(page, `#figure-${titles.indexOf(title)}`);
assert.deepEqual((await traces('Energies per cycle')).map(({name, points}) => [name, points]),
    [['identified joint', 160], ['truth', 160], ['input energy', 12], ['linear loss', 12],
      ['joint, D', 12]]);
assert.deepEqual((await traces('Slip-force density')).map(({name}) => name),
    ['95 % band', 'identified joint', 'truth']);
assert.deepEqual((await tools.plotted(page, `#figure-${titles.lastIndexOf('Slip-force density')}`)).map(({name}) => name),
    ['95 % band', 'identified joint', 'truth', 'smoothing spline']);
// Levels, five responses, and the true joint once in the legend.
assert.equal((await traces('Frequency responses at constant response')).length, 7);
assert.equal(await page.locator('#section-1-levels tbody tr').count(), 12);
const missing = await page.locator('.missing code').allTextContents();
assert.ok(missing.some((command) => command.startsWith('microslip verify')), missing.join('; '));
assert.ok((await page.locator('section:last-of-type').textContent()).includes('--bands 100'));
assert.deepEqual(faults, []);
console.log(`measured: ${JSON.stringify({bytes, milliseconds: await tools.times(page)})}`);

const alone = tools.folder(`${artefacts}/alone`);
const lonely = `${alone}/report.html`;
cpSync(`${test}/levels.csv`, `${alone}/levels.csv`);
run('report', alone, '--out', lonely);
const levels = await tools.open(browser, lonely);
await tools.takePictures(browser, lonely, alone, undefined, {opened: levels});
await tools.checkEveryFigure(levels.page);
assert.equal(await levels.page.locator('h2:text-is("Not in this report")').count(), 1);
assert.ok((await levels.page.locator('#section-0-summary').textContent()).includes('microslip identify'));
assert.deepEqual(levels.faults, []);

// A recording whose name and channels would do harm if anything took them for markup or a program.
const kHarm = '<img src=x onerror="window.harmed=1">';
const hostile = tools.folder(`${artefacts}/hostile`);
const name = `level_01'"&<script>alert(1)<|.csv`;
const rows = Array.from({length: 400}, (_, i) => {
  const t = i / 1000;
  return `${t},${Math.sin(345 * t)},${Math.cos(345 * t)}`;
});
writeFileSync(`${hostile}/${name}`, `time [s],"${kHarm.replaceAll('"', '""')} [N]","'; system ""touch harm"" %{x} $(x) [m/s^2]"\n` +
    `${rows.join('\n')}\n`);
run('report', hostile, '--title', `</title>${kHarm}`, '--out', `${hostile}/report.html`);
const inert = await tools.open(browser, `${hostile}/report.html`);
await tools.checkEveryFigure(inert.page);
assert.equal(await inert.page.evaluate(() => window.harmed), undefined);
assert.equal(await inert.page.locator('h1').textContent(), `</title>${kHarm}`);
const legends = (await inert.page.locator('.legend').allTextContents()).join(' ');
for (const text of [kHarm, `'; system "touch harm" %{x} $(x)`]) assert.ok(legends.includes(text), legends);
assert.ok((await inert.page.locator('main').textContent()).includes(name));
assert.ok(await inert.page.locator('.picture').count() > 0);
assert.equal(await inert.page.locator('main script, main [onerror]').count(), 0);
assert.equal(existsSync(`${test}/harm`), false);
assert.deepEqual(inert.faults, []);
await browser.close();
console.log('ok');
