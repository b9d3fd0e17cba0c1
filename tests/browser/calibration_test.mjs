// SPDX-License-Identifier: MIT

// node calibration_test.mjs MICROSLIP EXAMPLE FOLDER: the report of two joints from levels of modes, in a browser: what
// the first screen shows, on a desk and on a phone; two joints that are known only together. Pictures are left
// in FOLDER.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {copyFileSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import * as tools from './browser.mjs';

const [program, example, path] = process.argv.slice(2);
const browser = await tools.launch();
rmSync(path, {recursive: true, force: true});
const artefacts = tools.folder(path);
const run = (...args) => execFileSync(program, [...args, '--quiet'], {cwd: artefacts, stdio: 'inherit'});

/** Levels of both modes of a model with its joints, with 1 % of noise on the loss. */
function levelsOf(model) {
  let seed = 7;
  const noise = () => {
    seed = (seed * 16807) % 2147483647;
    return Math.sqrt(12) * (seed / 2147483647 - 0.5);
  };
  const rows = ['mode [1],displacement [m],frequency [Hz],dissipation [J],dissipation_std [J]'];
  for (const mode of [1, 2]) {
    run('backbone', model, '--mode', `${mode}`, '--response', '2um:0.5mm:25:log', '--out', 'b.csv');
    for (const line of readFileSync(`${artefacts}/b.csv`, 'utf8').split('\n')) {
      if (!/^[0-9]/.test(line)) continue;
      const [displacement, , frequency, , loss] = line.split(',').map(Number);
      rows.push([mode, displacement, frequency, loss * (1 + 0.01 * noise()), 0.01 * loss].join(','));
    }
  }
  return `${rows.join('\n')}\n`;
}

/** The report of the joints of a model as identified from its levels. */
function reportOf(name, model) {
  writeFileSync(`${artefacts}/${name}.toml`, model);
  writeFileSync(`${artefacts}/${name}_levels.csv`, levelsOf(`${name}.toml`));
  writeFileSync(`${artefacts}/${name}_unknown.toml`,
      model.replaceAll('file = "joint.json"', 'stiffness_N_per_m = 2000'));
  run('calibrate', `${name}_unknown.toml`, `${name}_levels.csv`, '--samples', '400', '--out', name);
  run('report', name, '--out', `${name}.html`);
  return `${artefacts}/${name}.html`;
}

/** Where the bottom of the first element is, in heights of the screen. */
const bottom = (page, selector) => page.locator(selector).first().evaluate(
    (element) => element.getBoundingClientRect().bottom / innerHeight);

copyFileSync(`${example}/joint.json`, `${artefacts}/joint.json`);
const model = readFileSync(`${example}/model.toml`, 'utf8');
const apart = reportOf('apart', model);
const bytes = tools.checkSize(apart);
const opened = await tools.open(browser, apart);
const {page, faults} = opened;
await tools.takePictures(browser, apart, `${artefacts}/apart`, [], {opened});
await tools.checkEveryFigure(page);
assert.deepEqual(await page.locator('figure h3').allTextContents(), ['Slip-force densities', 'Loss per cycle',
  'Loss, measured against found', 'Damping ratio', 'Frequency', 'Residuals of the losses',
  'Residuals of the frequencies', 'Displacement of wall', 'Displacement of middle', 'Share of wall in the loss',
  'Share of middle in the loss', 'Variance reduction', 'Density of wall', 'Density of middle']);
assert.match(await page.locator('.facts.prominent').first().textContent(), /50 of 50.*joints distinguishedall/s);
assert.equal(await page.locator('tr.marked').count(), 0);
await page.evaluate(() => scrollTo(0, 0));
assert.ok(await bottom(page, '#section-0-summary table') <= 1);
const reach = await page.locator('.beside').first().textContent();
for (const part of ['displacement, mode 12 to 500 µm, 25 levels', 'amplitude of wall', 'not verified on a level']) {
  assert.ok(reach.includes(part), `${part} in ${reach}`);
}
const drawn = (await tools.plotted(page, '#figure-0')).map(({name}) => name);
for (const name of ['wall', 'middle', 'wall: band', 'middle: band']) assert.ok(drawn.includes(name), `${name} in ${drawn}`);
assert.deepEqual(faults, []);

// Joints that cannot be distinguished are named before their densities.
const alike = reportOf('alike', model.replace(/^shape = \[0\.0, 1\.41.*\]/m,
    'shape = [0.7071067811865476, 0.7071067811865476]'));
const phone = await tools.open(browser, alike,
    {viewport: {width: 400, height: 850}, isMobile: true, hasTouch: true});
assert.match(await phone.page.locator('.warnings').textContent(), /known_only_together/);
assert.match(await phone.page.locator('.verdict').textContent(), /Do not rely on the densities of wall and middle by themselves/);
assert.match(await phone.page.locator('#section-0-summary p.text').first().textContent(),
    /wall and middle are known only together/);
assert.equal(await phone.page.locator('#section-0-summary tr.marked').count(), 2);
assert.match(await phone.page.locator('tr.marked').last().textContent(), /known only together$/);
assert.deepEqual(phone.faults, []);
await tools.takePictures(browser, alike, `${artefacts}/alike`, ['known_only_together']);
await browser.close();
console.log(`measured: ${JSON.stringify({bytes})}`);
console.log('ok');
