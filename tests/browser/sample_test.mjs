// SPDX-License-Identifier: MIT

// node sample_test.mjs SAMPLE_REPORT FOLDER: the report that the program SAMPLE_REPORT writes works in a
// browser as sample_report.cpp and the documentation of the report state. Pictures are left in FOLDER.

import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {writeFileSync} from 'node:fs';
import * as tools from './browser.mjs';

const [program, path] = process.argv.slice(2);
const artefacts = tools.folder(path);
const file = `${artefacts}/report.html`;
const browser = await tools.launch();
const results = {};

async function test(name, run) {
  try {
    await run();
    console.log(`ok: ${name}`);
  } catch (error) {
    console.error(`FAILED: ${name}\n${error.stack}`);
    process.exitCode = 1;
  }
}

writeFileSync(file, execFileSync(program, {maxBuffer: 1e8}));
const {page, faults} = await tools.open(browser, file);
const figure = (title) => page.locator('figure', {has: page.locator(`h3:text-is("${title}")`)});
const press = (title, name) => figure(title).getByRole('button', {name: `${name}: ${title}`, exact: true}).click();
const axis = (title, name) => figure(title).locator('.chart').evaluate(
    (chart, which) => chart.layout[which].type, name);

await test('is small', () => { results.bytes = tools.checkSize(file); });

await test('names out of files are texts', async () => {
  assert.equal(await page.evaluate(() => window.harmed), undefined);
  const found = await page.evaluate(() => ({
    scripts: document.scripts.length,
    links: [...document.querySelectorAll('a')].filter((a) => !a.hash).length,
    svgLinks: document.querySelectorAll('svg a').length,
    bold: document.querySelectorAll('svg b, svg tspan[style*=bold]').length,
    handlers: document.querySelectorAll('[onerror], [onclick], [onload]').length,
    images: [...document.images].filter((image) => !image.src.startsWith('data:')).length,
  }));
  assert.deepEqual(found, {scripts: 4, links: 0, svgLinks: 0, bold: 0, handlers: 0, images: 0});
  assert.ok((await page.title()).includes('</script>'));
  assert.ok((await page.locator('td').first().textContent()).startsWith('</script>'));
});

await test('figures have their points and units', async () => {
  assert.deepEqual((await tools.plotted(page, '#figure-0')).map(({points, y}) => [points, y]),
      [[90, 90], [90, 89], [90, 90]]);
  assert.deepEqual((await tools.plotted(page, '#figure-1')).map(({points}) => points), [101, 101, 101]);
  assert.deepEqual((await tools.plotted(page, '#figure-4')).map(({points}) => points), [9, 9]);
  assert.equal(await page.textContent('#figure-0 .xtitle'), 'amplitude A [µm]');
  assert.equal(await page.textContent('#figure-0 .ytitle'), 'energy per cycle [mJ]');
  assert.equal(await page.locator('.uplot canvas').count(), 2);
});

await test('the pointer shows values with names and units', async () => {
  await page.evaluate(() => Plotly.Fx.hover(document.querySelector('#figure-0 .chart'),
      [{curveNumber: 0, pointNumber: 10}]));
  const text = await page.textContent('#figure-0 .hoverlayer');
  assert.match(text, /amplitude A: 35 µm/);
  assert.match(text, /energy per cycle: 5\.\d+ mJ ± 0\.25/);
  assert.match(text, /measured/);
});

await test('the pointer shows names out of files as texts', async () => {
  await page.evaluate(() => Plotly.Fx.hover(document.querySelector('#figure-1 .chart'),
      [{curveNumber: 0, pointNumber: 10}]));
  const text = await page.textContent('#figure-1 .hoverlayer');
  assert.ok(text.includes('loop 0<a href="javascript'), text);
  assert.equal(await page.locator('svg a, svg tspan[style*=bold]').count(), 0);
});

await test('every figure is whole', () => tools.checkEveryFigure(page, true));

await test('log switches', async () => {
  assert.equal(await axis('Dissipation', 'yaxis'), 'log');
  await press('Dissipation', 'log y');
  assert.equal(await axis('Dissipation', 'yaxis'), 'linear');
  assert.equal(await axis('Dissipation', 'xaxis'), 'log');
  await press('Dissipation', 'log y');
  assert.equal(await axis('Dissipation', 'yaxis'), 'log');
});

/** Numbers at the ticks of a logarithmic axis, as they are read. */
const ticks = (title, name) => figure(title).locator(`.${name}tick text`).evaluateAll(
    (all) => all.map((one) => one.textContent.replaceAll('\u200b', '')));

// Powers of ten over three and more of them, else 1, 2, 5; of a part of a decade that a zoom shows, too.
await test('log axes are labelled as pictures for paper are', async () => {
  for (const label of await ticks('Dissipation', 'y')) assert.match(label, /^10−?\d$/);
  await page.evaluate(() => Plotly.relayout(document.querySelector('#figure-0 .chart'), {'xaxis.range': [1, 2.2]}));
  await page.waitForFunction(() => document.querySelectorAll('#figure-0 g.xtick').length === 4);
  assert.deepEqual(await ticks('Dissipation', 'x'), ['10', '20', '50', '100']);
  await press('Dissipation', 'Reset');
  await page.waitForFunction(() => document.querySelectorAll('#figure-0 g.xtick').length !== 4);
});

await test('the legend switches traces', async () => {
  const made = figure('Dissipation').locator('.legend button').first();
  await made.click();
  assert.equal(await made.getAttribute('aria-pressed'), 'false');
  assert.equal((await tools.plotted(page, '#figure-0')).length, 2);
  await made.click();
  assert.equal((await tools.plotted(page, '#figure-0')).length, 3);
});

await test('a choice holds for the figures of its section', async () => {
  await figure('Force').locator('select').selectOption({index: 2});
  for (const [title, index] of [['Acceleration', 2], ['Harmonics of the force', 0]]) {
    assert.equal(await figure(title).locator('select').evaluate((s) => s.selectedIndex), index);
  }
  const largest = await page.$eval('#figure-4 .chart', (chart) => Math.max(...chart.data[0].y));
  assert.equal(largest, 12);  // 8·3/2, see sample_report.cpp
});

await test('data as comma-separated text', async () => {
  await page.evaluate(() => {
    navigator.clipboard.writeText = (text) => { window.copied = text; return Promise.resolve(); };
  });
  await press('Dissipation', 'CSV');
  const lines = (await page.evaluate(() => window.copied)).trim().split('\n');
  assert.equal(lines.length, 91);
  assert.ok(lines[0].startsWith('amplitude A [µm],measured [mJ],measured std [mJ],identified [mJ],'));
  assert.equal(lines[1].split(',')[0], '2');
  assert.equal(lines[41].split(',')[3], '');  // the gap
  await page.getByRole('button', {name: /^Copy CSV: /}).click();
  const table = await page.evaluate(() => window.copied);
  assert.match(table, /\n"'=HYPERLINK\(""x""\)",,/);
  assert.match(table, /\nplain,-1234567,/);
});

await test('pictures to save', async () => {
  const stem = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, '-').slice(0, 80).replace(/^-|-$/g, '');
  const stems = Object.fromEntries(await Promise.all(['Loops', 'Force'].map(async (title) => {
    const section = await page.locator('section', {has: figure(title)}).locator('h2').textContent();
    const select = figure(title).locator('select');
    const choice = await select.count() ? await select.evaluate((s) => s.selectedOptions[0].textContent) : '';
    return [title, stem(`${section} ${title} ${choice}`)];
  })));
  for (const [title, format, head] of [['Loops', 'PNG', '\x89PNG'], ['Loops', 'SVG', '<svg'],
    ['Force', 'SVG', '<svg'], ['Force', 'PNG', '\x89PNG']]) {
    const button = figure(title).getByRole('button', {name: `${format}: ${title}`, exact: true});
    const {name, bytes} = await tools.download(page, button);
    assert.equal(name, `${stems[title]}.${format.toLowerCase()}`);
    assert.ok(bytes.length > 5000, `${name}: ${bytes.length} bytes`);
    assert.equal(bytes.subarray(0, 4).toString('latin1'), head);
    assert.ok(!bytes.includes('<a '), name);
    writeFileSync(`${artefacts}/${name}`, bytes);
  }
});

await test('the pointer shows values of a time history', async () => {
  const area = figure('Force').locator('.u-over');
  await area.hover({position: {x: 200, y: 80}});
  const text = await figure('Force').locator('.readout').textContent();
  assert.match(text, /^0\.0\d+ s: [^]* -?\d+\.\d+ N$/);
  await page.mouse.move(0, 0);
});

await test('the keyboard reaches everything', async () => {
  const fresh = await tools.open(browser, file);
  const keys = fresh.page.keyboard;
  const focused = () => fresh.page.evaluate(() => document.activeElement.className || document.activeElement.tagName);
  await keys.press('Tab');
  assert.equal(await focused(), 'skip');
  assert.ok((await fresh.page.locator('.skip').boundingBox()).x >= 0);
  await keys.press('Enter');
  await keys.press('Tab');
  assert.ok(await fresh.page.evaluate(() => document.querySelector('main').contains(document.activeElement)));
  const all = await fresh.page.$$eval('figure button, figure select, figure .chart, .table, nav a, nav button',
      (nodes) => nodes.filter(({tabIndex}) => tabIndex < 0).length);
  assert.equal(all, 0);
  await fresh.context.close();
});

await test('keys walk along the points', async () => {
  for (const title of ['Loops', 'Force']) {
    await figure(title).locator('.chart').focus();
    await page.keyboard.press('ArrowRight');
    const first = await figure(title).locator('.readout').textContent();
    await page.keyboard.press('ArrowRight');
    const second = await figure(title).locator('.readout').textContent();
    assert.ok(first.length > 0 && second !== first, `${title}: '${first}', '${second}'`);
    if (title === 'Loops') assert.match(first, /^loop 0<a href=.* -?[\d.]+ µm, -?[\d.]+ N$/);
  }
});

await test('keys and copies are announced aloud, and nothing else', async () => {
  const announced = () => page.locator('#announcement').textContent();
  await figure('Force').locator('.chart').focus();
  await page.keyboard.press('ArrowRight');
  const value = await announced();
  assert.equal(value, await figure('Force').locator('.readout').textContent());
  await figure('Force').locator('.u-over').hover({position: {x: 200, y: 80}});
  assert.notEqual(await figure('Force').locator('.readout').textContent(), value);
  assert.equal(await announced(), value);
  await press('Loops', 'CSV');
  assert.equal(await announced(), 'Copied');
  assert.equal(await page.locator('output, [aria-live], [role=status]').count(), 1);
  const hint = await figure('Force').locator('.chart').getAttribute('aria-describedby');
  assert.match(await page.locator(`#${hint}`).textContent(), /along the points/);
  await page.mouse.move(0, 0);
});

await test('the theme switch', async () => {
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const before = await ground();
  await page.locator('button.theme').click();
  assert.notEqual(await ground(), before);
  await page.locator('button.theme').click();
  assert.equal(await ground(), before);
});

await test('what has no text has an alternative', async () => {
  const bare = await page.evaluate(() => [...document.querySelectorAll('img, [role=img]')]
      .filter((node) => !(node.alt || node.getAttribute('aria-label'))).length);
  assert.equal(bare, 0);
  const alternative = await page.getAttribute('#figure-1 .chart', 'aria-label');
  assert.match(alternative, /force \[N\] over displacement \[µm\].*loop 2 from -40 to 40 N/);
});

await test('paper has the pictures', async () => {
  await page.emulateMedia({media: 'print'});
  assert.equal(await page.locator('#figure-1 .picture').isVisible(), true);
  assert.equal(await page.locator('#figure-1 .chart').isVisible(), false);
  assert.equal(await page.locator('nav').isVisible(), false);
  // Another level than that of the picture was chosen above: the picture followed.
  await page.waitForFunction(() => document.querySelector('#figure-2').dataset.paper === '2');
  assert.equal(await page.locator('#figure-2 .chart').isVisible(), false);
  assert.match(await page.locator('#figure-2 .chosen').innerText(), /./);
  for (const whole of await page.locator('figure').all()) {
    const [inner, outer] = [await whole.locator('.picture').boundingBox(), await whole.boundingBox()];
    assert.ok(inner.width > 100 && inner.height > 50);
    assert.ok(inner.x >= outer.x - 1 && inner.x + inner.width <= outer.x + outer.width + 1);
    assert.ok(inner.y + inner.height <= outer.y + outer.height + 1);
  }
  await page.emulateMedia({media: null});
});

await test('paper is white where the screen is dark', async () => {
  const dark = await tools.open(browser, file, {colorScheme: 'dark'});
  for (const press of [false, true]) {
    if (press) await dark.page.locator('button.theme').click();  // to light, and back to dark
    if (press) await dark.page.locator('button.theme').click();
    await dark.page.emulateMedia({media: 'print', colorScheme: 'dark'});
    const style = await dark.page.evaluate(() => {
      const {color, backgroundColor} = getComputedStyle(document.body);
      return {color, backgroundColor};
    });
    assert.deepEqual(style, {color: 'rgb(0, 0, 0)', backgroundColor: 'rgb(255, 255, 255)'});
    await dark.page.emulateMedia({media: null, colorScheme: 'dark'});
  }
  await dark.context.close();
});

await test('what is not defined is a gap of a history', async () => {
  const [whole, gap] = await page.evaluate(() => {
    const {plot} = views[2].chart;
    return [plot.data[1].includes(null), plot.series[1].spanGaps];
  });
  assert.deepEqual([whole, gap], [true, false]);
});

await test('a zoom lasts', async () => {
  const range = () => page.$eval('#figure-1 .chart', (chart) => [...chart.layout.xaxis.range]);
  await page.locator('#figure-1').scrollIntoViewIfNeeded();
  const whole = await range();
  const box = await page.locator('#figure-1 .nsewdrag').first().boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.3 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.7 * box.height, {steps: 5});
  await page.mouse.up();
  await page.waitForTimeout(400);  // a second click in this time would be a double click
  const zoomed = await range();
  assert.notDeepEqual(zoomed, whole);
  await page.locator('#figure-1 .legend button').first().click();
  assert.deepEqual(await range(), zoomed);
  await page.locator('#figure-1 .legend button').first().click();
  await press('Loops', 'Reset');
  assert.deepEqual(await range(), whole);
});

await test('a zoom of a time history ends by Reset', async () => {
  const range = () => page.evaluate(() => {
    const {min, max} = views[2].chart.plot.scales.x;
    return [min, max];
  });
  await page.locator('#figure-2').scrollIntoViewIfNeeded();
  const whole = await range();
  const box = await page.locator('#figure-2 .u-over').boundingBox();
  await page.mouse.move(box.x + 0.3 * box.width, box.y + 0.5 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.5 * box.height, {steps: 5});
  await page.mouse.up();
  const zoomed = await range();
  const share = (zoomed[1] - zoomed[0]) / (whole[1] - whole[0]);
  assert.ok(Math.abs(share - 0.3) < 0.02, `${zoomed} of ${whole}`);
  await press('Force', 'Reset');
  assert.deepEqual(await range(), whole);
});

await test('a picture and its chart have one width, and one legend', async () => {
  const plain = await tools.open(browser, file, {javaScriptEnabled: false});
  for (let i = 0; i < 5; ++i) {
    const [before, after] = await Promise.all([plain.page, page].map(
        (on) => on.locator(`#figure-${i} .canvas`).boundingBox()));
    assert.equal(before.width, after.width, `figure ${i}`);
    const picture = await plain.page.locator(`#figure-${i} .picture`).evaluate(
        ({naturalWidth, naturalHeight}) => naturalWidth / naturalHeight);
    assert.ok(picture > 0.6 * after.width / after.height, `figure ${i}: ${picture}`);
  }
  await plain.context.close();
  const legend = page.locator('#figure-0 .legend');
  await page.evaluate(() => document.querySelector('#figure-0').classList.remove('drawn'));
  assert.equal(await legend.isVisible(), false);
  await page.evaluate(() => document.querySelector('#figure-0').classList.add('drawn'));
  assert.equal(await legend.isVisible(), true);
});

await test('without scripts there are pictures and tables', async () => {
  const plain = await tools.open(browser, file, {javaScriptEnabled: false});
  assert.equal(await plain.page.locator('.picture').count(), 5);
  assert.equal(await plain.page.locator('#figure-3 .picture').isVisible(), true);
  assert.ok(await plain.page.$eval('#figure-3 .picture', ({naturalWidth}) => naturalWidth) > 0);
  assert.equal(await plain.page.locator('tbody tr').count(), 3);
  assert.equal(await plain.page.locator('.tools').count(), 0);
  await plain.page.emulateMedia({media: 'print'});
  for (const canvas of await plain.page.locator('.canvas').all()) {
    const [picture, room] = [await canvas.locator('.picture').boundingBox(), await canvas.boundingBox()];
    assert.ok(picture.height > 50 && room.height >= picture.height - 1, JSON.stringify({picture, room}));
  }
  await plain.context.close();
});

await test('light, dark, on a phone, on paper', () => tools.takePictures(browser, file, artefacts, undefined, {everywhere: true}));

await test('nothing went wrong on the way', () => assert.deepEqual(faults, []));

results.milliseconds = await tools.times(page);
console.log(`measured: ${JSON.stringify(results)}`);
writeFileSync(`${artefacts}/measured.json`, `${JSON.stringify(results)}\n`);
await browser.close();
