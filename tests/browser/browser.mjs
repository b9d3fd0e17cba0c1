// SPDX-License-Identifier: MIT

// Shared by the tests of the report in a browser.

import assert from 'node:assert/strict';
import {existsSync, mkdirSync, readFileSync, statSync} from 'node:fs';
import {pathToFileURL} from 'node:url';

const kSkipped = 77;  // see SKIP_RETURN_CODE in CMakeLists.txt
const kChromium = process.env.MICROSLIP_CHROMIUM ?? '/usr/bin/chromium';
const kMostBytes = 4e6;

function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(kSkipped);
}

/** Starts Chromium, or skips the test where it or playwright-core is missing. */
export async function launch() {
  if (!existsSync(kChromium)) skip(`${kChromium} is not there (apt-get install chromium)`);
  let playwright;
  try {
    playwright = await import('playwright-core');
  } catch {
    skip('playwright-core is not there (npm ci in tests/browser)');
  }
  return playwright.chromium.launch({
    executablePath: kChromium,
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run',
      '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
}

const kDesk = {width: 1300, height: 900};
const kNarrow = {width: 400, height: 850};
const kPhone = {width: 390, height: 844};

/** Opens a report and notes all that a report must not do. Returns when all figures are charts, or when the page answers where
    `until` is 'ready'; with its times where it is `timed`. */
export async function open(browser, file, {until = 'drawn', timed = false, ...options} = {}) {
  const context = await browser.newContext({viewport: kDesk, ...options});
  const page = await context.newPage();
  const timing = timed ? await startTiming(page) : undefined;
  const faults = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) faults.push(`console: ${message.text()}`);
  });
  page.on('pageerror', (error) => faults.push(`error: ${error.message}`));
  page.on('dialog', (dialog) => faults.push(`dialog: ${dialog.message()}`));
  page.on('popup', (popup) => faults.push(`popup: ${popup.url()}`));
  const url = pathToFileURL(file).href;
  page.on('request', (request) => {
    const inside = /^(data|blob):/.test(request.url()) || request.url() === url;
    if (!inside) faults.push(`request: ${request.url()}`);
  });
  await page.goto(url);
  if (options.javaScriptEnabled !== false) {
    await page.waitForSelector(`html[data-${until === 'ready' ? 'ready=true' : 'drawn=all'}]`, {timeout: 120000});
  }
  return {page, context, faults, ...(timing ? await timing() : {})};
}

/** The traces of a plotly figure as it has them, without those that only close an area. */
export function plotted(page, selector) {
  return page.$eval(`${selector} .chart`, (chart) => chart.data
      .filter((trace) => trace.showlegend !== false)
      .map(({name, x, y}) => ({name, points: x.length, y: y.filter(Number.isFinite).length})));
}

/** A figure by its title, of a section where several have the same. */
export function figure(page, title, section = '') {
  return page.locator(`${section} figure`, {has: page.locator(`h3:text-is("${title}")`)}).first();
}

/** The figures in the data of the report: titles, units, and the points of each shown trace. */
function expectedFigures(page) {
  return page.evaluate(() => {
    const figures = JSON.parse(document.getElementById('report-data').textContent);
    const length = (traces, {x}) => x.count ?? (x.of === undefined ? x.length : length(traces, traces[x.of]));
    return figures.map(({title, chart, x, y, chosen, choices}) => {
      const {traces} = choices[chosen];
      const drawn = traces.filter(({kind, shown}) => shown && kind !== 'marker');
      return {title, chart, x, y, chosen, choices: choices.length,
        points: drawn.map((trace) => length(traces, trace) + (trace.kind === 'loop' ? 1 : 0))};
    });
  });
}

/** Every figure has its points, units, buttons and alternatives, and its switches work: those of logarithmic axes of the first
    figure of those with the same switches, and of all where `everySwitch` or in the studies. */
export async function checkEveryFigure(page, everySwitch = Boolean(process.env.MICROSLIP_STUDIES)) {
  const expected = await expectedFigures(page);
  const kinds = new Set();
  const nodes = page.locator('figure.figure');
  assert.equal(await nodes.count(), expected.length);
  await chartsFit(page);
  for (const [i, figure] of expected.entries()) {
    const node = nodes.nth(i);
    const name = `figure ${i}, ${figure.title}`;
    assert.equal(await node.locator('h3').textContent(), figure.title);
    const axes = [figure.y, figure.x].map(({label, unit}) => `${label} [${unit}]`);
    const alternative = await node.locator('.chart').getAttribute('aria-label');
    assert.ok(alternative.startsWith(`${figure.title}: ${axes[0]} over ${axes[1]}`), alternative);
    for (const label of ['Reset', 'CSV', 'PNG', 'SVG']) {
      assert.equal(await node.getByRole('button', {name: `${label}: ${figure.title}`, exact: true}).count(), 1, `${name}: ${label}`);
    }
    if (figure.chart === 'time') {
      assert.equal(await node.locator('.uplot canvas').count(), 1, name);
      assert.deepEqual(await timeCharts(page, i), {labels: [figure.x, figure.y].map(({label, unit}) => `${label} [${unit}]`),
        points: figure.points}, name);
    } else {
      const chart = await node.locator('.chart').evaluate((element) => element.data
          .filter(({hoverinfo}) => hoverinfo !== 'skip').map(({x}) => x.length));
      assert.deepEqual(chart, figure.points, name);
      assert.equal(await node.locator('.ytitle').textContent(), axes[0]);
      assert.equal(await node.locator('.xtitle').textContent(), axes[1]);
      const kind = JSON.stringify([figure.x.switch, figure.x.log, figure.y.switch, figure.y.log]);
      await checkLogSwitches(node, figure, name, everySwitch || !kinds.has(kind));
      kinds.add(kind);
    }
    await checkChoices(page, i, node, figure, name);
  }
}

/** Each chart is as high as its place, also when a neighbour in its row changes that. */
async function chartsFit(page) {
  const misfits = () => page.evaluate(() => views.map(({area, figure}) => {
    const chart = area.querySelector('.main-svg, .uplot');
    return [figure.title, Math.round(chart.getBoundingClientRect().bottom - area.getBoundingClientRect().bottom)];
  }).filter(([, below]) => below > 1));
  const until = Date.now() + 5000;
  while ((await misfits()).length > 0 && Date.now() < until) await page.waitForTimeout(50);
  assert.deepEqual(await misfits(), []);
}

/** The axes and the points of each line of a time history. */
function timeCharts(page, figure) {
  return page.evaluate((i) => {
    const {plot} = views[i].chart;
    return {labels: plot.axes.map(({label}) => label),
      points: plot.data.slice(1).map((values) => values.filter((y) => y !== undefined).length)};
  }, figure);
}

/** The drawn content as a text. */
function drawnText(page, figure) {
  return page.evaluate((i) => {
    const {chart} = views[i];
    return JSON.stringify(chart.plot ? chart.plot.data : chart.element.data.map(({x, y}) => [[...x], [...y]]));
  }, figure);
}

/** @param work  whether they are switched, too. */
async function checkLogSwitches(node, figure, name, work) {
  for (const axis of ['x', 'y']) {
    const made = node.getByRole('button', {name: `log ${axis}: ${figure.title}`, exact: true});
    assert.equal(await made.count(), figure[axis].switch ? 1 : 0, `${name}: log ${axis}`);
    if (!figure[axis].switch || !work) continue;
    const type = () => node.locator('.chart').evaluate((element, of) => element.layout[`${of}axis`].type, axis);
    for (const log of [!figure[axis].log, figure[axis].log]) {
      await made.evaluate((button) => button.click());  // sample_test.mjs has the mouse do it
      assert.equal(await type(), log ? 'log' : 'linear', `${name}: log ${axis}`);
      assert.equal(await made.getAttribute('aria-pressed'), String(log));
    }
  }
}

async function checkChoices(page, i, node, figure, name) {
  const select = node.locator('select');
  assert.equal(await select.count(), figure.choices > 1 ? 1 : 0, name);
  if (figure.choices < 2) return;
  assert.equal(await select.locator('option').count(), figure.choices, name);
  const before = await select.inputValue();
  const drawn = await drawnText(page, i);
  await select.selectOption({index: figure.chosen === 0 ? 1 : 0});
  assert.notEqual(await node.locator('.legend button').count(), 0, name);
  assert.notEqual(await drawnText(page, i), drawn, name);
  await select.selectOption(before);
  assert.equal(await drawnText(page, i), drawn, name);
}

/** Milliseconds from the start of the navigation. */
export function times(page) {
  return page.evaluate(() => Object.fromEntries(performance.getEntriesByType('mark')
      .filter(({name}) => name.startsWith('microslip-'))
      .map(({name, startTime}) => [name.slice('microslip-'.length), Math.round(startTime)])));
}

/** Begins to time a page that is not loaded yet. What it returns ends that when all figures are charts, with the times of the
    load in ms: until the first screen and the first chart are drawn and the page answers, until all figures are charts, and
    the time of the processor until the former, which other programs on the machine do not lengthen. A page answers early
    because it draws no more until then than its first screen and the first chart: that is asserted, the times are not, for
    they are the machine's. */
async function startTiming(page) {
  await page.addInitScript(() => {
    const mark = performance.mark.bind(performance);
    performance.mark = (name, ...more) => {
      if (name === 'microslip-interactive') window.chartsDrawn = document.querySelectorAll('figure.drawn').length;
      return mark(name, ...more);
    };
  });
  const session = await page.context().newCDPSession(page);
  const events = [];
  session.on('Tracing.dataCollected', ({value}) => events.push(...value));
  await session.send('Tracing.start', {categories: 'blink.user_timing', transferMode: 'ReportEvents'});
  return async () => {
    const complete = new Promise((done) => { session.once('Tracing.tracingComplete', done); });
    await session.send('Tracing.end');
    await complete;
    await session.detach();
    const charts = await page.evaluate(() => window.chartsDrawn);
    assert.ok(charts >= 1 && charts <= 2, `${charts} charts are drawn before the page answers`);
    // tts: µs of its thread since that began, which is before the navigation did.
    const {tts} = events.find(({name}) => name === 'microslip-interactive');
    return {load: {...await times(page), processor: Math.round(tts / 1000)}};
  };
}

/** The least times of a first load and, in the studies, of two more. */
export async function leastTimes(browser, file, first) {
  const loads = [first];
  while (process.env.MICROSLIP_STUDIES && loads.length < 3) {
    const {context, load} = await open(browser, file, {timed: true});
    loads.push(load);
    await context.close();
  }
  return Object.fromEntries(Object.keys(first).map((key) => [key, Math.min(...loads.map((load) => load[key]))]));
}

export function checkSize(file) {
  const bytes = statSync(file).size;
  assert.ok(bytes <= kMostBytes, `${bytes} bytes`);
  return bytes;
}

export function folder(path) {
  mkdirSync(path, {recursive: true});
  return path;
}

/** The first screen, before scrolling: the verdict on the joint, the names of the warnings, the density with
    its axes. All sections can be reached, and nothing is wider than the screen. @param warnings  codes that must be
    there in words. */
async function checkFirstScreen(page, name, {width: screenWidth, height: screenHeight}, warnings) {
  const box = (selector) => page.locator(selector).first().boundingBox();
  const shown = ['.verdict', '#figure-0 .chart', ...(warnings.length > 0 ? ['.verdict .codes'] : [])];
  for (const selector of shown) {
    const {x, y, width, height} = await box(selector);
    assert.ok(width > 0 && height > 0, `${name}: ${selector} is empty`);
    assert.ok(x >= 0 && x + width <= screenWidth && y + height <= screenHeight,
        `${name}: ${selector} ends at ${x + width}, ${y + height}`);
  }
  for (const code of warnings) {
    assert.ok((await page.locator('.verdict .codes').first().textContent()).includes(code.replaceAll('_', ' ')), `${name}: ${code}`);
  }
  const wide = await page.evaluate(() => [...document.querySelectorAll('body, nav a, nav button, figure, .chart, .table-block, .facts, .warnings li')]
      .map((node) => [node.className || node.textContent, node.getBoundingClientRect().right])
      .filter(([, right]) => right > innerWidth + 0.5));
  assert.deepEqual(wide, [], name);
}

/** Saves the file of a button and returns its bytes. */
export async function download(page, locator) {
  const [file] = await Promise.all([page.waitForEvent('download'), locator.click()]);
  return {name: file.suggestedFilename(), bytes: readFileSync(await file.path())};
}

/** A report in both themes on a desk, on a phone and in a narrow window, with screenshots, and in print. All charts are drawn
    for the light theme, and for the phone where it is looked at `everywhere`; the rest differ from these by their first screen.
    Of most reports the dark theme and the phone are left to the studies: the page is the same.
    @param warnings  where they are given, what the first screen must name.
    @param opened    the report as `open` has opened it, on a desk; it stays open. */
export async function takePictures(browser, file, artefacts, warnings, {everywhere = false, opened} = {}) {
  const all = everywhere || Boolean(process.env.MICROSLIP_STUDIES);
  const kinds = {
    light: {viewport: kDesk, colorScheme: 'light'},
    ...(all ? {dark: {viewport: kDesk, colorScheme: 'dark'}, phone: {viewport: kPhone, isMobile: true, hasTouch: true}} : {}),
    ...(warnings === undefined ? {} : {narrow: {viewport: kNarrow, colorScheme: 'dark'}}),
  };
  for (const [name, options] of Object.entries(kinds)) {
    const whole = ['light', 'phone'].includes(name);
    const given = name === 'light' ? opened : undefined;
    const {page, context, faults} = given ?? await open(browser, file, {...options, until: whole ? 'drawn' : 'ready'});
    await page.screenshot({path: `${artefacts}/first_${name}.png`});
    if (warnings !== undefined) await checkFirstScreen(page, name, options.viewport, warnings);
    const {content, screen} = await page.evaluate(() => ({
      content: document.documentElement.scrollWidth, screen: innerWidth}));
    assert.ok(content <= screen, `${name}: ${content} px wide on ${screen}`);
    if (whole) await page.screenshot({path: `${artefacts}/${name}.png`, fullPage: true});
    if (name === 'light') {
      await page.pdf({path: `${artefacts}/print.pdf`, preferCSSPageSize: true});
      const loaded = await page.$$eval('.picture', (all) => all.filter(
          ({complete, naturalWidth}) => complete && naturalWidth > 0).length);
      assert.equal(loaded, await page.locator('.picture').count(), 'pictures in print');
      await page.emulateMedia({media: 'print'});
      const grids = await page.$$eval('.figures, .beside', (all) => all.filter(
          (element) => /grid|flex/.test(getComputedStyle(element).display)).length);
      assert.equal(grids, 0, 'a grid leaves its heading alone at the end of a page');
      await page.emulateMedia({media: null});
    }
    assert.deepEqual(faults, [], name);
    if (!given) await context.close();
  }
}
