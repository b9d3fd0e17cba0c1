// SPDX-License-Identifier: MIT

/** Time histories, by uPlot: thousands of points move with the finger. */
class TimeChart {
  /** @param readout  gets the values at the cursor. */
  constructor(element, figure, readout) {
    library('uplot');
    this.element = element;
    this.figure = figure;
    this.readout = readout;
    this.pointed = -1;
  }

  draw(state) {
    this.state = state;
    const shown = state.traces.filter((trace) => !state.hidden.has(trace.group));
    const zoom = this.plot && this.chosen === state.chosen ? {...this.plot.scales.x} : null;
    this.chosen = state.chosen;
    this.plot?.destroy();
    this.shown = shown;
    const tables = shown.map((trace) => [trace.x, trace.y]);
    const data = tables.length ? uPlot.join(tables) : [[0, 1]];
    this.plot = new uPlot(this.options(shown, theme.colours()), data, this.element);
    if (zoom) this.plot.setScale('x', {min: zoom.min, max: zoom.max});
  }

  resize() { this.plot.setSize(this.size()); }

  reset() {
    const times = this.plot.data[0];
    this.plot.setScale('x', {min: times[0], max: times.at(-1)});
  }

  /** uPlot draws on a canvas: pictures to save are drawn by plotly.js. */
  image(format, form) {
    const chart = new PlotChart(null, this.figure);
    chart.state = {...this.state, logX: false, logY: false};
    return chart.image(format, form);
  }

  step(points) {
    const times = this.plot.data[0];
    this.pointed = (((this.pointed + points) % times.length) + times.length) % times.length;
    const left = this.plot.valToPos(times[this.pointed], 'x');
    this.plot.setCursor({left, top: this.plot.over.clientHeight / 2});
    return this.readout.textContent;
  }

  size() { return {width: this.element.clientWidth, height: this.element.clientHeight}; }

  options(shown, colours) {
    const axis = (from, size) => ({
      label: `${from.label} [${from.unit}]`,
      labelFont: `12.5px ${kFont}`,
      font: `12px ${kFont}`,
      labelSize: 22,
      size,
      values: (plot, splits) => splits.map(
          (value) => value === null ? '' : String(Number(value.toPrecision(9))).replace('-', '−')),
      stroke: colours.ink,
      grid: {stroke: colours.grid, width: 1},
      ticks: {stroke: colours.muted, width: 1, size: 4},
    });
    const dashes = {solid: [], dash: [8, 5], dot: [2, 4], dashdot: [8, 4, 2, 4], longdash: [14, 6]};
    return {
      ...this.size(),
      scales: {x: {time: false}},
      axes: [axis(this.figure.x, 30), axis(this.figure.y, 56)],
      series: [{}, ...shown.map((trace) => ({
        label: '',  // the legend of the page shows it
        stroke: colours.series[trace.colour],
        width: trace.width,
        dash: dashes[trace.style],
        spanGaps: false,
        points: {show: false},
      }))],
      legend: {show: false},
      cursor: {sync: {key: `section-${this.figure.section}`}},
      hooks: {setCursor: [(plot) => this.showReadout(plot)]},
    };
  }

  showReadout(plot) {
    const i = plot.cursor.idx;
    if (i === null || i === undefined) {
      this.readout.textContent = '';
      return;
    }
    const values = this.shown.map((trace, j) => `${trace.name} ${readable(plot.data[j + 1][i])}`);
    const {x, y} = this.figure;
    this.readout.textContent = `${readable(plot.data[0][i])} ${x.unit}: ${values.join(', ')} ${y.unit}`;
  }
}
