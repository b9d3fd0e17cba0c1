// SPDX-License-Identifier: MIT

const kSwatches = {
  line: (style) => ({d: 'M0 6H22', style}),
  loop: (style) => ({d: 'M0 6H22', style}),
  points: () => ({d: 'M11 6h0', wide: true}),
  bars: () => ({d: 'M4 6H18', wide: true}),
  band: () => ({d: 'M0 6H22', band: true}),
};

const kDashes = {dash: '5 3', dot: '2 3', dashdot: '5 3 2 3', longdash: '8 3'};

function swatch(trace) {
  const space = 'http://www.w3.org/2000/svg';
  const {d, style, wide, band} = kSwatches[trace.kind](trace.style);
  const svg = document.createElementNS(space, 'svg');
  const path = document.createElementNS(space, 'path');
  const set = (target, attributes) => {
    for (const [name, value] of Object.entries(attributes)) target.setAttribute(name, value);
  };
  set(svg, {viewBox: '0 0 22 12', width: 22, height: 12, 'aria-hidden': 'true'});
  set(path, {d, class: `colour-${trace.colour}`,
    'stroke-width': band ? 12 : wide ? 7 : 2, 'stroke-linecap': trace.kind === 'points' ? 'round' : 'butt',
    'stroke-opacity': band ? 0.25 : 1});
  if (kDashes[style]) path.setAttribute('stroke-dasharray', kDashes[style]);
  svg.append(path);
  return svg;
}

/** A figure of the page: its chart, legend and buttons. */
class FigureView {
  /** @param node  the <figure>. @param figure  of the report's data. @param choose  called with a choice. */
  constructor(node, figure, choose) {
    this.node = node;
    this.figure = figure;
    this.chart = null;
    this.known = new Set();  // names whose traces had their first turn
    this.state = {logX: figure.x.log, logY: figure.y.log, hidden: new Set(), traces: []};
    this.area = node.querySelector('.chart');
    this.paper = node.querySelector('.picture') ?? this.area.parentNode.appendChild(
        element('img', {className: 'picture', alt: this.area.getAttribute('aria-label')}));
    this.legend = element('ul', {className: 'legend'});
    this.readout = element('div', {className: 'readout'});
    node.querySelector('.head').append(this.tools(choose));
    node.querySelector('.head').after(this.legend);
    node.querySelector('.canvas').after(this.readout);
    this.choose(figure.chosen);
    this.listen();
  }

  get drawn() { return this.chart !== null; }

  /** Draws it for the first time, or again. */
  draw() {
    if (!this.chart) {
      const Kind = this.figure.chart === 'time' ? TimeChart : PlotChart;
      this.chart = new Kind(this.area, this.figure, this.readout);
      this.node.classList.add('drawn');
      // Its place changes with the window, and with a neighbour in its row.
      new ResizeObserver(() => this.resize()).observe(this.area);
    }
    this.size = this.place();
    this.chart.draw(this.state);
  }

  redraw() { if (this.drawn) this.draw(); }

  place() { return `${this.area.clientWidth} ${this.area.clientHeight}`; }

  resize() {
    if (this.size === this.place() || !this.area.clientWidth) return;
    this.size = this.place();
    this.chart.resize();
  }

  get choice() { return this.figure.choices[this.chosen]; }

  /** "Force over time, level_03.csv (1.2 m/s²)". */
  get title() {
    return this.choice.name ? `${this.figure.title}, ${this.choice.name}` : this.figure.title;
  }

  /** Shows the content of a choice; what was switched on or off by name stays so. */
  choose(index) {
    this.chosen = index;
    if (this.select) this.select.selectedIndex = index;
    this.state.chosen = index;
    this.state.traces = this.choice.traces;
    const chosen = this.node.querySelector('.chosen');
    if (chosen) chosen.textContent = `${this.figure.choose}: ${this.choice.name}`;
    for (const {group, shown} of this.state.traces) {
      if (!shown && !this.known.has(group)) this.state.hidden.add(group);
      this.known.add(group);
    }
    this.fillLegend();
    this.change();
  }

  /** Draws it again after the reader changed it; the picture for paper follows when there is time. */
  change() {
    if (!this.drawn) return;
    this.draw();
    clearTimeout(this.waiting);
    this.waiting = setTimeout(() => this.drawPaper(), 300);
  }

  /** Makes the picture for paper that of the chart. */
  async drawPaper() {
    const wide = this.node.classList.contains('wide');
    const size = {width: wide ? 760 : 420, height: 300};
    this.paper.src = await this.chart.image('svg', size);
    this.node.dataset.paper = this.chosen;
  }

  fillLegend() {
    const entries = new Map(this.state.traces.map((trace) => [trace.group, trace]).reverse());
    entries.delete('');  // what has no legend cannot be turned off
    for (const {group, kind} of this.state.traces) {
      if (kind === 'marker') entries.delete(group);  // its name stands at the line
    }
    this.legend.replaceChildren(...[...entries].reverse().map(([name, trace]) => {
      const made = button('', 'Show or hide', () => this.toggle(name, made));
      made.append(swatch(trace), element('span', {textContent: name}));
      made.setAttribute('aria-pressed', String(!this.state.hidden.has(name)));
      return element('li', {}, made);
    }));
  }

  toggle(name, made) {
    const {hidden} = this.state;
    if (!hidden.delete(name)) hidden.add(name);
    made.setAttribute('aria-pressed', String(!hidden.has(name)));
    this.change();
  }

  tools(choose) {
    const tools = element('div', {className: 'tools'});
    if (this.figure.choices.length > 1) tools.append(this.selector(choose));
    if (this.figure.x.switch) tools.append(this.logSwitch('x', 'logX'));
    if (this.figure.y.switch) tools.append(this.logSwitch('y', 'logY'));
    tools.append(
        button('Reset', 'Show all again (or double-click the figure)', () => this.chart?.reset()),
        button('CSV', 'Copy the data as comma-separated text', async (made) => {
          const text = csv.ofFigure(this.figure, this.state.traces);
          confirmOn(made, await copyOrSave(text, this.name));
        }),
        ...['PNG', 'SVG'].map((format) => button(format, `Save as ${format} picture`,
            () => this.saveImage(format.toLowerCase()))));
    for (const made of tools.querySelectorAll('button')) {
      made.setAttribute('aria-label', `${made.textContent}: ${this.figure.title}`);
    }
    return tools;
  }

  /** Of files: no two figures of a report have the same. */
  get name() {
    const section = this.node.closest('section')?.querySelector('h2')?.textContent ?? '';
    return fileName(`${section} ${this.title}`);
  }

  selector(choose) {
    this.select = element('select', {}, ...this.figure.choices.map(
        (choice) => element('option', {textContent: choice.name})));
    this.select.addEventListener('change', () => choose(this, this.select.selectedIndex));
    return element('label', {}, element('span', {textContent: `${this.figure.choose} `}), this.select);
  }

  logSwitch(axis, key) {
    const made = button(`log ${axis}`, `Logarithmic ${axis} axis`, () => {
      this.state[key] = !this.state[key];
      made.setAttribute('aria-pressed', String(this.state[key]));
      this.change();
    });
    made.setAttribute('aria-pressed', String(this.state[key]));
    return made;
  }

  async saveImage(format) {
    if (!this.drawn) this.draw();
    const url = await this.chart.image(format, {title: this.title});
    const comma = url.indexOf(',');
    const body = url.slice(comma + 1);
    const bytes = url.slice(0, comma).endsWith('base64')
      ? Uint8Array.from(atob(body), (c) => c.charCodeAt(0)) : decodeURIComponent(body);
    const type = format === 'svg' ? 'image/svg+xml' : 'image/png';
    save(`${this.name}.${format}`, new Blob([bytes], {type}));
  }

  /** Left and right move along a trace, up and down from trace to trace. */
  listen() {
    const moves = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
    this.area.tabIndex = 0;
    // The keys are for the chart, and only what they find is read aloud.
    this.area.setAttribute('role', 'application');
    this.area.setAttribute('aria-roledescription', 'chart');
    this.area.setAttribute('aria-describedby', 'keys');
    this.area.addEventListener('keydown', (event) => {
      const move = moves[event.key];
      if (!move || !this.drawn) return;
      event.preventDefault();
      this.readout.textContent = this.chart.step(...move);
      announce(this.readout.textContent);
    });
    this.area.addEventListener('blur', () => { this.readout.textContent = ''; });
  }
}
