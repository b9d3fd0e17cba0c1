// SPDX-License-Identifier: MIT

// node records_test.mjs MICROSLIP FOLDER: the report of a joint from records of force and
// displacement, in a browser: what the first screen shows, on a desk and on a phone. Pictures are left in
// FOLDER.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {rmSync, writeFileSync} from 'node:fs';
import * as tools from './browser.mjs';

const [program, path] = process.argv.slice(2);
const browser = await tools.launch();
rmSync(path, {recursive: true, force: true});
const artefacts = tools.folder(path);
const run = (...args) => execFileSync(program, [...args, '--quiet'], {cwd: artefacts, stdio: 'inherit'});

/** Force of sliders of 2 to 120 µm on a sum of sines that grows from rest, with even noise; and a force that
    follows the velocity. */
function recording(viscous) {
  const sliders = Array.from({length: 60}, (_, i) => ({most: 2 * (i + 1), force: 0}));
  let seed = 1;
  const noise = () => { seed = (seed * 48271) % 2147483647; return seed / 2147483647 - 0.5; };
  const rows = ['time [s],displacement [um],force [N]'];
  let before = 0;
  for (let i = 0; i < 6000; ++i) {
    const t = i / 1000;
    const u = 70 * Math.min(1, t / 2) * (Math.sin(6.1 * t) + Math.sin(9.7 * t + 1) - Math.sin(1));
    let force = 0.02 * u + viscous * (u - before);
    for (const slider of sliders) {
      slider.force = Math.max(-slider.most, Math.min(slider.most, slider.force + u - before));
      force += 2e-3 * slider.force;
    }
    before = u;
    rows.push(`${t},${u + 0.05 * noise()},${force + 0.05 * noise()}`);
  }
  return `${rows.join('\n')}\n`;
}

/** The report of a folder with one recording. */
function reportOf(name, viscous) {
  const folder = tools.folder(`${artefacts}/${name}`);
  writeFileSync(`${folder}/rec.csv`, recording(viscous));
  run('identify', `${name}/rec.csv`, '--samples', '200', '--out', `${name}/joint.json`);
  run('report', name, '--out', `${name}/report.html`);
  return `${folder}/report.html`;
}

/** Where the bottom of the first element is, in heights of the screen. */
const bottom = (page, selector) => page.locator(selector).first().evaluate(
    (element) => element.getBoundingClientRect().bottom / innerHeight);

const good = reportOf('good', 0);
const bytes = tools.checkSize(good);
const opened = await tools.open(browser, good);
const {page, faults} = opened;
await tools.takePictures(browser, good, `${artefacts}/good`, [], {opened});
await tools.checkEveryFigure(page);
const titles = await page.locator('figure h3').allTextContents();
assert.deepEqual(titles, ['Slip-force density', 'Force over time', 'Residual over time',
  'Measured and found loops', 'Residual over displacement', 'Dissipation of the joint',
  'Secant stiffness', 'Loss factor of the joint']);
const facts = await page.locator('.facts.prominent').first().textContent();
assert.match(facts, /stuck stiffness k, 95 % band1\d\d\.\d{1,2} ± \d\.\d+ kN\/m/);
assert.match(facts, /none of 7/);
assert.equal(await page.locator('#section-0-summary tbody tr').count(), 7);
assert.equal(await page.locator('#section-0-summary tr.marked').count(), 0);
// Stiffness, density with its band, and all verdicts without a turn of the wheel.
await page.evaluate(() => scrollTo(0, 0));
for (const shown of ['.facts.prominent', '#figure-0 .canvas', '#section-0-summary table']) {
  assert.ok(await bottom(page, shown) <= 1, shown);
}
assert.deepEqual((await tools.plotted(page, '#figure-0')).map(({name}) => name),
    ['95 % band', 'identified joint']);
assert.deepEqual(faults, []);

// On a phone nothing is wider than the screen, and the figures that matter come first.
const broken = reportOf('broken', 1.5);
const phone = await tools.open(browser, broken,
    {viewport: {width: 400, height: 850}, isMobile: true, hasTouch: true});
assert.match(await phone.page.locator('.warnings').textContent(), /rate_dependent/);
assert.match(await phone.page.locator('.warnings').textContent(), /--viscous fit/);
assert.equal(await phone.page.locator('#section-0-summary tr.marked').count(), 1);
assert.match(await phone.page.locator('tr.marked').first().textContent(), /^the force follows/);
assert.match(await phone.page.locator('.verdict').textContent(), /Not a Masing joint.*the force follows the velocity/);
assert.deepEqual(phone.faults, []);
await tools.takePictures(browser, broken, `${artefacts}/broken`, ['rate_dependent']);
await browser.close();
console.log(`measured: ${JSON.stringify({bytes})}`);
console.log('ok');
