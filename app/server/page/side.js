// SPDX-License-Identifier: GPL-3.0-or-later
// Tabs of the side panel, and its width.
import {el, replace, set_text} from './dom.js';
import {store} from './store.js';

const kTabs = [
  ['inspect', 'Inspect'],
  ['ledger', 'Ledger'],
  ['charts', 'Charts'],
  ['warnings', 'Warnings'],
  ['change', 'Change'],
  ['log', 'Log']
];
const kLeast = 280,
  kMost = 720;

/// -> {inspect: element, ...}
export function build_side(root) {
  const panels = {},
    tabs = {};
  for (const [name, caption] of kTabs) {
    tabs[name] = el(
      'button',
      {
        type: 'button',
        role: 'tab',
        id: `tab-${name}`,
        'aria-controls': `panel-${name}`,
        onclick: () => store.set('tab', name)
      },
      caption
    );
    panels[name] = el('div', {role: 'tabpanel', id: `panel-${name}`, 'aria-labelledby': `tab-${name}`, class: 'panel'});
  }
  const list = el('div', {role: 'tablist', 'aria-label': 'Side panel'}, Object.values(tabs));
  list.addEventListener('keydown', (event) => {
    const names = kTabs.map(([name]) => name),
      i = names.indexOf(store.get('tab'));
    const next = {ArrowRight: i + 1, ArrowLeft: i - 1 + names.length, Home: 0, End: names.length - 1}[event.key];
    if (next === undefined) return;
    event.preventDefault();
    store.set('tab', names[next % names.length]);
    tabs[store.get('tab')].focus();
  });
  replace(root, list, Object.values(panels));
  const show = (tab) => {
    for (const [name] of kTabs) {
      tabs[name].setAttribute('aria-selected', String(name === tab));
      tabs[name].tabIndex = name === tab ? 0 : -1;
      panels[name].hidden = name !== tab;
    }
  };
  store.on('tab', show);
  store.on('warnings', (warnings) =>
    set_text(tabs.warnings, warnings.length ? `Warnings ${warnings.length}` : 'Warnings')
  );
  show(store.get('tab'));
  return panels;
}

export function attach_splitter(splitter, desk) {
  let width = Number(localStorage.getItem('side')) || 372;
  const set = (wanted) => {
    width = Math.round(Math.min(kMost, Math.max(kLeast, Math.min(wanted, window.innerWidth - 420))));
    desk.style.setProperty('--side', `${width}px`);
    splitter.setAttribute('aria-valuenow', String(width));
    localStorage.setItem('side', String(width));
  };
  splitter.setAttribute('aria-valuemin', String(kLeast));
  splitter.setAttribute('aria-valuemax', String(kMost));
  splitter.dataset.keys = '';
  splitter.addEventListener('pointerdown', (event) => splitter.setPointerCapture(event.pointerId));
  splitter.addEventListener('pointermove', (event) => {
    if (splitter.hasPointerCapture(event.pointerId)) set(window.innerWidth - event.clientX - 3);
  });
  splitter.addEventListener('keydown', (event) => {
    const by = {ArrowLeft: 24, ArrowRight: -24}[event.key];
    if (!by) return;
    event.preventDefault();
    set(width + by);
  });
  set(width);
}
