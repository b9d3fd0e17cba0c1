// SPDX-License-Identifier: MIT

// node demo_test.mjs DEMO FOLDER: the reports that `microslip demo --out DEMO` has left, in a browser.
// Pictures are left in FOLDER.

import assert from 'node:assert/strict';
import {rmSync, writeFileSync} from 'node:fs';
import * as tools from './browser.mjs';

const [demo, path] = process.argv.slice(2);
const browser = await tools.launch();
rmSync(path, {recursive: true, force: true});
const artefacts = tools.folder(path);

const measured = {};

/** Opens a report, looks at all of its figures and does with it what `more` does. Its first screen names these warnings. */
async function check(name, warnings, more) {
  const file = `${demo}/${name}/report.html`;
  const bytes = tools.checkSize(file);
  const opened = await tools.open(browser, file, {timed: true});
  const {page, context, faults, load} = opened;
  await tools.takePictures(browser, file, tools.folder(`${artefacts}/${name}`), warnings,
      {everywhere: name === 'reference_rig', opened});
  await tools.checkEveryFigure(page);
  await more(page);
  assert.deepEqual(faults, [], name);
  await context.close();
  const milliseconds = await tools.leastTimes(browser, file, load);
  measured[name] = {bytes, milliseconds};
}

await check('reference_rig', [], async (page) => {
  assert.deepEqual(await page.locator('h2').allTextContents(),
      ['Summary', 'Levels', 'Signals', 'Energies', 'Density', 'Loops', 'Stiffness and damping',
        'Responses', 'Prediction', 'Rig', 'Provenance']);
  assert.equal(await page.locator('#section-1-levels tbody tr').count(), 90);
  const shown = async (title, section) => tools.figure(page, title, section).locator('.legend button')
      .evaluateAll((all) => all.map((one) => [one.textContent, one.getAttribute('aria-pressed')]));
  // Before and after force control, at a level that has both records.
  const signals = '#section-2-signals';
  assert.deepEqual(await shown('Force over time', signals), [['force', 'true'], ['before control', 'true']]);
  assert.deepEqual(await shown('Acceleration over time', signals),
      [['acc1', 'true'], ['acc2', 'true'], ['acc3', 'true'], ['before control', 'false']]);
  assert.deepEqual(await shown('Force over time', '#section-8-prediction'),
      [['force, recorded', 'true'], ['predicted', 'true']]);
  // One choice for all histories and harmonics of a section, and for no other section.
  const select = (title, section) => tools.figure(page, title, section).locator('select');
  await select('Force over time', signals).selectOption({index: 0});
  assert.match(await select('Displacement over time', signals).locator('option:checked').textContent(),
      /^level_01\.csv \(0\.294 m/);
  assert.match(await select('Force over time', '#section-8-prediction').locator('option:checked')
      .textContent(), /^level_90\.csv/);
  assert.equal(await page.locator('.missing').count(), 0);
});

await check('brake_reuss_beam', ['frequency_rises', 'few_levels', 'damping_ambiguous'], async (page) => {
  assert.equal(await page.locator('#section-1-levels tbody tr').count(), 8);
  assert.ok(await page.locator('.warnings li').count() > 0);
  assert.match(await page.locator('.verdict').textContent(), /Not a Masing joint.*the frequency does not fall/);
  const energies = await tools.figure(page, 'Energies per cycle').locator('.legend').textContent();
  assert.match(energies, /identified joint.*with damping βA².*D, with damping βA²/);
});

console.log(`measured: ${JSON.stringify(measured)}`);
writeFileSync(`${artefacts}/measured.json`, `${JSON.stringify(measured)}\n`);
await browser.close();
console.log('ok');
