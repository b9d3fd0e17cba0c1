// SPDX-License-Identifier: MIT

/** Text as plotly.js shows it as it is: it takes some HTML tags and references for markup, and %{…} for a
    value. */
function plain(text) {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;')
      .replaceAll('%{', '%&#123;');
}

/** Where a logarithmic axis has its ticks, and what stands there, as in pictures for paper (axis_ticks.cpp): powers of ten
    where there are three or more, else 1, 2, 5, and even steps on a part of a decade.
    @param range  decimal logarithms of the ends. @param length  px, and what a label takes of it. */
function logTicks([from, to], {length, label}) {
  const inside = (value) => Math.log10(value) >= from - 1e-9 && Math.log10(value) <= to + 1e-9;
  const multiples = (digits) => {
    const values = [];
    for (let power = Math.floor(from); power <= Math.floor(to); ++power) {
      values.push(...digits.map((digit) => Number(`${digit}e${power}`)).filter(inside));
    }
    return values;
  };
  const fits = (values) => values.every((value, i) => i === 0 ||
      length * Math.log10(value / values[i - 1]) / (to - from) >= label);
  const all = multiples([1, 2, 3, 4, 5, 6, 7, 8, 9]);
  const powers = multiples([1]);
  const minor = {ticks: 'outside', ticklen: 2, tickmode: 'array', tickvals: all};
  if (powers.length >= 3) {
    const stride = [1, 2, 3, 5, 10, 20, 50, 100, 200].find((step) => fits(
        powers.filter((value) => Math.round(Math.log10(value)) % step === 0))) ?? 200;
    const shown = powers.filter((value) => Math.round(Math.log10(value)) % stride === 0);
    return {tickmode: 'array', tickvals: shown, minor: stride === 1 ? minor : {...minor, tickvals: powers},
      ticktext: shown.map((value) => `10<sup>${minus(Math.round(Math.log10(value)))}</sup>`)};
  }
  const some = [multiples([1, 2, 5]), all].find((values) => values.length >= 3);
  if (!some) return {tickmode: 'auto', exponentformat: 'power', minorloglabels: 'complete'};
  const shown = fits(some) ? some : powers;
  return {tickmode: 'array', tickvals: shown, ticktext: shown.map(withPower), minor};
}

function minus(number) { return String(number).replace('-', '−'); }

/** With the power of ten apart where the number is very large or small: 2×10⁻⁵. */
function withPower(value) {
  const power = Math.floor(Math.log10(value) + 1e-9);
  if (power >= -4 && power < 4) return minus(Number(value.toPrecision(4)));
  return `${Math.round(value / 10 ** power)}×10<sup>${minus(power)}</sup>`;
}

/** A number to read. */
function readable(value) {
  return value === null || value === undefined ? '–' : String(Number(value.toPrecision(4)));
}

/** Curves, points, bands and bars on a pair of axes, by plotly.js. */
class PlotChart {
  /** @param element  where it is drawn. @param figure  of the report's data. */
  constructor(element, figure) {
    library('plotly');
    this.element = element;
    this.figure = figure;
    this.pointed = {trace: 0, point: -1};
    this.ticked = {};  // what the ticks that are drawn were made for, see tickKey()
  }

  /** @param state  {traces, hidden: Set of groups, logX, logY} */
  draw(state) {
    this.state = state;
    const {data, layout} = this.picture(theme.colours());
    const first = !this.element.layout;
    for (const name of ['x', 'y']) this.ticked[name] = this.tickKey(name, layout[`${name}axis`].range);
    Plotly.react(this.element, data, layout, {displayModeBar: false, responsive: false});
    if (first) this.element.on('plotly_relayout', () => this.tickAgain());
    this.tickAgain();  // a zoom may have lasted
  }

  /** Key of all that the ticks of a logarithmic axis depend on. */
  tickKey(name, range) { return `${range} ${this.length(name).length}`; }

  /** Ticks of logarithmic axes for what they show now: a part after a zoom, in the place that there is. */
  tickAgain() {
    const {logX, logY} = this.state;
    const changes = {};
    for (const [name, log] of [['x', logX], ['y', logY]]) {
      const {range} = this.element.layout[`${name}axis`];
      const key = this.tickKey(name, range);
      if (!log || this.ticked[name] === key) continue;
      this.ticked[name] = key;
      for (const [what, value] of Object.entries(logTicks(range, this.length(name)))) {
        changes[`${name}axis.${what}`] = value;
      }
    }
    if (Object.keys(changes).length > 0) Plotly.relayout(this.element, changes);
  }

  async resize() {
    await Plotly.Plots.resize(this.element);
    this.tickAgain();
  }

  reset() { Plotly.relayout(this.element, this.ranges()); }

  /** @param title  of a picture that stands alone; none beside the text of the page.
      @return a promise of the picture as a data URL. */
  async image(format, {title, width = 800, height = 520} = {}) {
    const {data, layout} = this.picture(theme.lightColours());
    layout.paper_bgcolor = '#ffffff';
    if (title) {
      layout.title = {text: plain(title), font: {size: 15}, x: 0.02, xanchor: 'left'};
      layout.margin.t = 44;
    }
    layout.showlegend = true;
    layout.legend = {orientation: 'h', y: -0.2, font: {size: 12}};
    return Plotly.toImage({data, layout}, {format, width, height, scale: 2});
  }

  /** Steps through the points of the traces by the keyboard. @return a text for the point. */
  step(points, traces) {
    const data = this.element.data;
    const usable = data.flatMap((trace, i) => (trace.hoverinfo === 'skip' ? [] : [i]));
    if (usable.length === 0) return '';
    const wrap = (value, size) => ((value % size) + size) % size;
    this.pointed.trace = wrap(this.pointed.trace + traces, usable.length);
    const curveNumber = usable[this.pointed.trace];
    const {x, y, meta, customdata} = data[curveNumber];
    this.pointed.point = wrap(this.pointed.point + points, x.length);
    const pointNumber = this.pointed.point;
    Plotly.Fx.hover(this.element, [{curveNumber, pointNumber}]);
    const unit = (axis) => (axis.unit === '1' ? '' : ` ${axis.unit}`);
    const from = customdata ? `${readable(customdata[pointNumber])} to ` : '';
    return `${meta}: ${readable(x[pointNumber])}${unit(this.figure.x)}, ` +
        `${from}${readable(y[pointNumber])}${unit(this.figure.y)}`;
  }

  picture(colours) {
    const {traces, hidden} = this.state;
    const shown = traces.filter((trace) => !hidden.has(trace.group));
    const curves = shown.filter((trace) => trace.kind !== 'marker');
    const markers = shown.filter((trace) => trace.kind === 'marker');
    return {
      data: curves.flatMap((trace) => this.curve(trace, colours)),
      layout: this.layout(colours, markers),
    };
  }

  curve(trace, colours) {
    const colour = colours.series[trace.colour];
    const line = {color: colour, width: trace.width, dash: trace.style, simplify: false};
    const first = this.state.traces.find(({group}) => group === trace.group) === trace;
    const common = {name: plain(trace.group), meta: trace.name, showlegend: first, x: trace.x, y: trace.y,
      hovertemplate: this.hover(trace)};
    switch (trace.kind) {
      case 'band': return this.band(trace, colour);
      case 'points': return [{...common, type: 'scatter', mode: 'markers', ...this.marks(trace, colour)}];
      case 'bars': return [{...common, type: 'bar', marker: {color: colour}}];
      case 'loop': return [{...common, type: 'scatter', mode: 'lines', line,
        x: [...trace.x, trace.x[0]], y: [...trace.y, trace.y[0]]}];
      default: return [{...common, type: 'scatter', mode: 'lines', line}];
    }
  }

  marks(trace, colour) {
    // Open ones, through which a curve of a model can be seen; dots where hundreds are a cloud.
    const many = trace.x.length > 40 && trace.x.length <= 400;
    const size = trace.x.length > 400 ? 2.5 : many ? 5.5 : 6;
    const marks = {marker: {color: colour, symbol: many ? 'circle-open' : 'circle', size}};
    const bars = (array) => ({type: 'data', array, color: colour, thickness: 1, width: 2});
    if (trace.xStd) marks.error_x = bars(trace.xStd);
    if (trace.yStd) marks.error_y = bars(trace.yStd);
    return marks;
  }

  /** Zero has no place on a logarithmic axis: there the band goes down out of sight. */
  band(trace, colour) {
    const floor = this.state.logY ? this.floor() : -Infinity;
    const lower = trace.lower.map((value) => Math.max(value, floor));
    const edge = {type: 'scatter', mode: 'lines', x: trace.x, line: {width: 0}, hoverinfo: 'skip',
      showlegend: false};
    return [{...edge, y: lower},
      {...edge, y: trace.upper, name: plain(trace.name), meta: trace.name, showlegend: true, fill: 'tonexty',
        fillcolor: faded(colour, 0.18), hoverinfo: 'all', customdata: trace.lower,
        hovertemplate: this.hover(trace)}];
  }

  hover(trace) {
    const part = (axis, name) => {
      const unit = axis.unit === '1' ? '' : ` ${plain(axis.unit)}`;
      return `${plain(axis.label)}: %{${name}:.4~g}${unit}`;
    };
    const std = trace.yStd ? ' ± %{error_y.array:.2~g}' : '';
    const to = trace.lower ? ', lower end: %{customdata:.4~g}' : '';
    return `${part(this.figure.x, 'x')}<br>${part(this.figure.y, 'y')}${std}${to}` +
        `<extra>${plain(trace.name)}</extra>`;
  }

  /** Far below the smallest positive value of the curves. */
  floor() {
    const values = this.state.traces.filter((trace) => trace.y).flatMap((trace) => trace.y);
    const positive = values.filter((value) => value > 0);
    return Math.min(...positive, 1) * 1e-3;
  }

  ranges() {
    const {logX, logY} = this.state;
    // That of the scale at first.
    const range = (axis, log) => {
      if (!axis.range || log !== axis.log) return null;
      return log ? axis.range.map(Math.log10) : axis.range;
    };
    const all = (axis, log) => this.aboutOne(axis, log) ?? (log ? this.valuesRange(axis) : null);
    const x = range(this.figure.x, logX) ?? all('x', logX);
    const y = range(this.figure.y, logY) ?? this.positiveRange() ?? all('y', logY);
    return {'xaxis.range': x, 'xaxis.autorange': x === null, 'yaxis.range': y, 'yaxis.autorange': y === null};
  }

  /** Of an axis with hardly more than one value on it, which plotly.js would leave without a tick to read. */
  aboutOne(axis, log) {
    if (axis === 'y' && this.state.traces.some(({yStd, upper}) => yStd || upper)) return null;
    const values = this.state.traces.flatMap((trace) => trace[axis] ?? [])
        .filter((value) => value !== null && (!log || value > 0));
    if (values.length === 0) return null;
    const low = values.reduce((a, b) => Math.min(a, b));
    const high = values.reduce((a, b) => Math.max(a, b));
    if (log) return high > 1.05 * low ? null : [Math.log10(low) - 0.3, Math.log10(high) + 0.3];
    const most = Math.max(Math.abs(low), Math.abs(high));
    return high - low > 1e-6 * most || most === 0 ? null : [low - 0.1 * most, high + 0.1 * most];
  }

  /** Decimal logarithms of the ends of what is drawn over an axis, with a margin. */
  valuesRange(axis) {
    const values = this.state.traces.filter(({group}) => !this.state.hidden.has(group))
        .flatMap((trace) => (axis === 'x' ? trace.x : [...(trace.y ?? []), ...(trace.upper ?? []), ...(trace.lower ?? [])]))
        .filter((value) => value > 0);
    if (values.length === 0) return [0, 1];
    const low = Math.log10(values.reduce((a, b) => Math.min(a, b)));
    const high = Math.log10(values.reduce((a, b) => Math.max(a, b)));
    const margin = 0.04 * (high - low);
    const bars = axis === 'y' && this.state.traces.some(({kind}) => kind === 'bars');
    return [low - (bars ? 0.3 : margin), high + margin];  // the lowest bar has a height, too
  }

  /** Of an axis in px, and what a label of it takes. */
  length(axis) {
    const {clientWidth, clientHeight} = this.element ?? {clientWidth: 800, clientHeight: 520};
    return axis === 'x' ? {length: clientWidth - 70, label: 44} : {length: clientHeight - 60, label: 18};
  }

  /** Of a logarithmic y axis with a band that reaches zero: that of the curves. */
  positiveRange() {
    const {traces, logY} = this.state;
    if (!logY || !traces.some((trace) => trace.kind === 'band')) return null;
    const values = traces.flatMap((trace) => [...(trace.y ?? []), ...(trace.upper ?? [])])
        .filter((value) => value > 0);
    const largest = Math.max(...values);
    return [Math.log10(Math.max(Math.min(...values), 1e-6 * largest)) - 0.2, Math.log10(largest) + 0.1];
  }

  axis(name, log, range, colours) {
    const axis = this.figure[name];
    return {
      title: {text: `${plain(axis.label)} [${plain(axis.unit)}]`, standoff: 8, font: {size: 12.5}},
      type: log ? 'log' : 'linear',
      range: range ?? undefined,
      autorange: range === null,
      gridcolor: colours.grid,
      linecolor: colours.muted,
      tickcolor: colours.muted,
      ticks: 'outside',
      ticklen: 4,
      showline: true,
      zeroline: false,
      exponentformat: 'power',
      minexponent: 4,  // 0.0001 and 10 000 without: as in pictures for paper
      automargin: true,
      ...(log ? logTicks(range ?? this.valuesRange(name), this.length(name)) : {}),
    };
  }

  /** Whether a marker is so far left that its text has no room there. */
  isLeft(marker) {
    const values = this.state.traces.flatMap(({x}) => x).filter((x) => !this.state.logX || x > 0);
    const scaled = (x) => (this.state.logX ? Math.log(x) : x);
    const from = scaled(Math.min(...values));
    return scaled(marker.x[0]) - from < 0.1 * (scaled(Math.max(...values)) - from);
  }

  layout(colours, markers) {
    const {logX, logY} = this.state;
    const ranges = this.ranges();
    const place = (marker) => (logX ? Math.log10(marker.x[0]) : marker.x[0]);
    return {
      autosize: true,
      uirevision: `${this.state.chosen} ${logX} ${logY}`,  // a zoom lasts as long as these
      margin: {l: 56, r: 14, t: markers.length ? 14 + 14 * Math.ceil(markers.length / 2) : 10, b: 44},
      paper_bgcolor: 'rgba(0,0,0,0)',
      plot_bgcolor: 'rgba(0,0,0,0)',
      font: {family: kFont, size: 12, color: colours.ink},
      showlegend: false,
      hovermode: 'closest',
      hoverlabel: {bgcolor: colours.paper, bordercolor: colours.muted, align: 'left',
        font: {family: kFont, size: 12, color: colours.ink}, namelength: 40},
      // A finger scrolls the page.
      dragmode: matchMedia('(pointer: coarse)').matches ? false : 'zoom',
      barmode: 'group',
      bargap: 0.35,
      xaxis: this.axis('x', logX, ranges['xaxis.range'], colours),
      yaxis: this.axis('y', logY, ranges['yaxis.range'], colours),
      shapes: markers.map((marker) => ({type: 'line', x0: marker.x[0], x1: marker.x[0], y0: 0, y1: 1,
        yref: 'paper', line: {color: colours.muted, width: 1, dash: 'dash'}})),
      // Above the frame, where they hide no curve: two in a row.
      annotations: markers.map((marker, i) => ({text: plain(marker.name), x: place(marker), y: 1,
        yref: 'paper', yanchor: 'bottom', xanchor: this.isLeft(marker) ? 'left' : 'right',
        yshift: 14 * Math.floor(i / 2), showarrow: false, font: {size: 11, color: colours.muted}})),
    };
  }
}
