// SPDX-License-Identifier: MIT

/** Comma-separated text; a text that a spreadsheet would run as a formula gets an apostrophe. */
const csv = {
  cell(value) {
    if (value === null || value === undefined || Number.isNaN(value)) return '';
    if (typeof value === 'number') return String(value);
    const inert = /^[=+\-@\t\r]/.test(value) && Number.isNaN(Number(value)) ? `'${value}` : value;
    return /[",;\n]/.test(inert) ? `"${inert.replaceAll('"', '""')}"` : inert;
  },

  /** @param columns  arrays with the name of the column first; short ones are filled up. */
  ofColumns(columns) {
    const rows = Math.max(...columns.map((column) => column.length));
    const lines = [];
    for (let i = 0; i < rows; ++i) {
      lines.push(columns.map((column) => csv.cell(column[i])).join(','));
    }
    return `${lines.join('\n')}\n`;
  },

  /** One x for all traces of a figure that have the same, otherwise one beside each. */
  ofFigure(figure, traces) {
    const drawn = traces.filter((trace) => trace.kind !== 'marker');
    const common = drawn.every((trace) => sameNumbers(trace.x, drawn[0].x));
    const x = `${figure.x.label} [${figure.x.unit}]`;
    const columns = common ? [[x, ...drawn[0].x]] : [];
    for (const trace of drawn) {
      const head = (what) => `${trace.name}${what} [${figure.y.unit}]`;
      if (!common) columns.push([`${trace.name}: ${x}`, ...trace.x]);
      if (trace.y) columns.push([head(''), ...trace.y]);
      if (trace.yStd) columns.push([head(' std'), ...trace.yStd]);
      if (trace.lower) columns.push([head(' lower'), ...trace.lower]);
      if (trace.upper) columns.push([head(' upper'), ...trace.upper]);
    }
    return csv.ofColumns(columns);
  },

  ofTable(table) {
    const text = (cell) => cell.textContent.trim();
    const lines = [...table.rows].map((row) => [...row.cells].map((cell) => {
      const number = cell.dataset.value;
      return csv.cell(number === undefined ? text(cell) : number);
    }).join(','));
    return `${lines.join('\n')}\n`;
  },
};

function sameNumbers(a, b) {
  return a === b || (a.length === b.length && a.every((value, i) => value === b[i]));
}

function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** To the clipboard, or as a file where the browser does not let us. @return what was done. */
async function copyOrSave(text, name) {
  try {
    await navigator.clipboard.writeText(text);
    return 'Copied';
  } catch {
    save(`${name}.csv`, new Blob([text], {type: 'text/csv'}));
    return 'Saved';
  }
}

function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  Object.assign(made, properties);
  made.append(...children);
  return made;
}

function button(label, title, act) {
  const made = element('button', {type: 'button', textContent: label, title});
  made.addEventListener('click', () => act(made));
  return made;
}

/** To those who hear the page. */
function announce(text) { document.getElementById('announcement').textContent = text; }

/** Says on a button for a moment, and aloud, what it has done. */
function confirmOn(made, text) {
  announce(text);
  const label = made.dataset.label ?? made.textContent;
  made.dataset.label = label;
  made.textContent = text;
  clearTimeout(made.timer);
  made.timer = setTimeout(() => { made.textContent = label; }, 1500);
}

function fileName(title) {
  return title.toLowerCase().replace(/[^a-z0-9]+/g, '-').slice(0, 80).replace(/^-|-$/g, '') || 'figure';
}

/** Runs a library, which waits in the page as a text until the first chart needs it: the browser takes
    longer for it than for all else of the page. */
function library(id) {
  const text = document.getElementById(id);
  if (text?.type === 'text/plain') text.replaceWith(element('script', {id, textContent: text.textContent}));
}

/** A button that copies a table. */
function equipTable(block) {
  const table = block.querySelector('table');
  const title = block.querySelector('h3').textContent;
  const tools = element('div', {className: 'tools'});
  const copy = button('Copy CSV', 'Copy this table as comma-separated text', async (made) => {
    confirmOn(made, await copyOrSave(csv.ofTable(table), fileName(title)));
  });
  copy.setAttribute('aria-label', `Copy CSV: ${title}`);
  tools.append(copy);
  block.querySelector('.head').append(tools);
}
