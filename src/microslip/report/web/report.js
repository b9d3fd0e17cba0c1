// SPDX-License-Identifier: MIT

/** Pictures for paper of figures that have none, one after the other. */
async function drawPapers(views) {
  for (const view of views) {
    if (view.paper.getAttribute('src')) continue;
    await view.drawPaper();
    await new Promise(whenIdle);
  }
  document.documentElement.dataset.papers = 'all';
}

/** When the browser has time, or soon where it never has. */
function whenIdle(act) {
  if (window.requestIdleCallback) requestIdleCallback(act, {timeout: 500});
  else setTimeout(act, 20);
}

function isOnScreen({node}) {
  const {top, bottom} = node.getBoundingClientRect();
  return bottom > 0 && top < innerHeight;
}

/** After the browser has shown what was drawn and can handle what the reader does; a page in the background
    is shown later, if ever. */
function afterFrame(act) {
  let waits = true;
  const once = () => {
    if (waits) act();
    waits = false;
  };
  requestAnimationFrame(() => setTimeout(once));
  setTimeout(once, 2000);
}

/** Draws the figures on the screen at once, each other one when it comes near it, and the rest when the
    browser has time. */
function drawAll(views) {
  const waiting = new Set(views);
  const byNode = new Map(views.map((view) => [view.node, view]));
  const draw = (view) => {
    if (waiting.delete(view)) view.draw();
  };
  views.filter(isOnScreen).forEach(draw);

  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) if (entry.isIntersecting) draw(byNode.get(entry.target));
  }, {rootMargin: '200px'});
  const next = () => {
    const [view] = waiting;
    if (!view) {
      performance.mark('microslip-all-drawn');
      document.documentElement.dataset.drawn = 'all';
      drawPapers(views);
      return;
    }
    draw(view);
    whenIdle(next);
  };
  // The larger library takes its time when its first chart comes: before the page counts as ready.
  const first = views.find(({figure}) => figure.chart !== 'time');
  afterFrame(() => {
    if (first) draw(first);
    afterFrame(() => {
      performance.mark('microslip-interactive');
      document.documentElement.dataset.ready = 'true';
      views.forEach((view) => near.observe(view.node));
      whenIdle(next);
    });
  });
}

function addThemeSwitch() {
  const made = button('', '', () => theme.toggle());
  made.className = 'theme';
  const label = () => {
    made.textContent = theme.isDark() ? 'Light' : 'Dark';
    made.title = `Switch to the ${theme.isDark() ? 'light' : 'dark'} theme`;
  };
  label();
  theme.onChange(label);
  document.querySelector('nav').append(made);
}

/** Text for screen readers only: what was done, and how to use a chart. */
function addSpoken() {
  document.body.append(element('output', {className: 'spoken', id: 'announcement'}), element('p', {className: 'spoken',
    id: 'keys', textContent: 'Left and right move along the points, up and down from curve to curve.'}));
}

/** Marks the section that is being read in the navigation. */
function followSections() {
  const links = new Map([...document.querySelectorAll('nav a')].map(
      (link) => [document.getElementById(link.hash.slice(1)), link]));
  const watch = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      const link = links.get(entry.target);
      if (entry.isIntersecting) link.setAttribute('aria-current', 'true');
      else link.removeAttribute('aria-current');
    }
  }, {rootMargin: '-20% 0px -75% 0px'});
  for (const section of links.keys()) watch.observe(section);
}

/** The data of the figures, with x as numbers where they are even or those of another trace. */
function readData() {
  const figures = JSON.parse(document.getElementById('report-data').textContent);
  for (const {traces} of figures.flatMap(({choices}) => choices)) {
    for (const trace of traces) {
      const {from, step, count, of} = trace.x;
      if (count) trace.x = Array.from({length: count}, (_, i) => from + i * step);
      if (of !== undefined) trace.x = traces[of].x;
    }
  }
  return figures;
}

const views = [];

function start() {
  const figures = readData();
  // A figure of the section that lacks this choice keeps the one it has.
  const choose = (from, index) => {
    const {section, choose: what, choices} = from.figure;
    for (const view of views) {
      if (view.figure.section !== section || view.figure.choose !== what) continue;
      const same = view.figure.choices.findIndex(({name}) => name === choices[index].name);
      if (same >= 0) view.choose(same);
    }
  };
  for (const node of document.querySelectorAll('figure[data-figure]')) {
    views.push(new FigureView(node, figures[Number(node.dataset.figure)], choose));
  }
  document.querySelectorAll('.table-block').forEach(equipTable);
  addThemeSwitch();
  addSpoken();
  followSections();
  theme.onChange(() => views.forEach((view) => view.redraw()));
  addEventListener('beforeprint', () => {
    for (const picture of document.querySelectorAll('.picture')) picture.loading = 'eager';
  });
  drawAll(views);
}

start();
