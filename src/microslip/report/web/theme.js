// SPDX-License-Identifier: MIT
'use strict';

/** Light or dark, and the colours of the style sheet for what is drawn by scripts. */
const theme = (() => {
  const root = document.documentElement;
  const system = matchMedia('(prefers-color-scheme: dark)');
  const listeners = [];

  const isDark = () => (root.dataset.theme ? root.dataset.theme === 'dark' : system.matches);
  const notify = () => listeners.forEach((listener) => listener());

  function colours() {
    const style = getComputedStyle(root);
    const colour = (name) => style.getPropertyValue(`--${name}`).trim();
    return {
      ink: colour('ink'),
      muted: colour('muted'),
      paper: colour('paper'),
      grid: colour('grid'),
      series: Array.from({length: 8}, (_, i) => colour(`series-${i}`)),
    };
  }

  /** The colours of the light theme: pictures that are saved go into papers. */
  function lightColours() {
    const before = root.dataset.theme;
    root.dataset.theme = 'light';
    const found = colours();
    if (before) root.dataset.theme = before;
    else delete root.dataset.theme;
    return found;
  }

  system.addEventListener('change', notify);
  return {
    isDark,
    colours,
    lightColours,
    toggle() {
      root.dataset.theme = isDark() ? 'light' : 'dark';
      notify();
    },
    onChange(listener) { listeners.push(listener); },
  };
})();

/** A translucent version of #rrggbb. */
function faded(colour, opacity) {
  const part = (from) => parseInt(colour.slice(from, from + 2), 16);
  return `rgba(${part(1)}, ${part(3)}, ${part(5)}, ${opacity})`;
}

const kFont = 'system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif';
