// SPDX-License-Identifier: GPL-3.0-or-later
// The help overlay.
import {button, el} from './dom.js';

const kKeys = [
  [
    'Run',
    [
      ['Space', 'run or pause'],
      ['S', 'one increment'],
      ['U', 'run until…'],
      ['/', 'console line']
    ]
  ],
  [
    'Look',
    [
      ['← → ↑ ↓', 'turn (with Shift: move)'],
      ['+ −', 'zoom'],
      ['F', 'fit the whole part'],
      ['1 … 7', 'iso, front, back, right, left, top, bottom'],
      ['Enter', 'pick what is in the middle']
    ]
  ],
  [
    'Time',
    [
      ['[ ]', 'kept state before, after'],
      ['L', 'newest state, live']
    ]
  ],
  [
    'Page',
    [
      ['T', 'light or dark'],
      ['?', 'this help'],
      ['Esc', 'close, or let go of the selection']
    ]
  ]
];
const kMouse = [
  ['Drag', 'turn'],
  ['Shift or middle drag', 'move'],
  ['Wheel, pinch', 'zoom where the pointer is'],
  ['Click', 'pick a node'],
  ['Ctrl or Alt drag', 'rectangle of nodes'],
  ['Double click', 'fit']
];

export function show_help() {
  if (document.querySelector('dialog.help')) return;
  const list = (pairs, tag) =>
    el(
      'dl',
      {},
      pairs.map(([key, text]) => el('div', {}, el('dt', {}, el(tag, {}, key)), el('dd', {}, text)))
    );
  const dialog = el(
    'dialog',
    {class: 'help', 'aria-label': 'Help'},
    el(
      'header',
      {},
      el('h2', {}, 'Keys and mouse'),
      button({icon: 'close', title: 'Close', kind: 'quiet'}, () => dialog.close())
    ),
    el(
      'div',
      {class: 'columns'},
      kKeys.map(([title, pairs]) => el('section', {}, el('h3', {}, title), list(pairs, 'kbd'))),
      el('section', {}, el('h3', {}, 'Mouse and touch'), list(kMouse, 'span'))
    ),
    el(
      'p',
      {class: 'faint'},
      'Buttons, fields, keys and the console line send the same commands; each is written to journal.jsonl with its increment.'
    )
  );
  dialog.addEventListener('close', () => dialog.remove());
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  document.body.append(dialog);
  dialog.showModal();
}
