// SPDX-License-Identifier: GPL-3.0-or-later
// Warnings of the run: a list that stays, and short notices as they happen.
import {button, el, replace} from './dom.js';
import {format} from './numbers.js';
import {store} from './store.js';
import {show_time} from './timeline.js';

const kMostToasts = 3;
const parts = {};

export function build_warnings(root, toasts) {
  parts.list = el('ol', {class: 'warnings', id: 'warning-list'});
  parts.toasts = toasts;
  replace(root, parts.list);
  store.on('warnings', draw);
  draw();
}

function draw() {
  const warnings = store.get('warnings');
  if (!warnings.length)
    return replace(
      parts.list,
      el(
        'li',
        {class: 'hint'},
        'No warnings so far. Negative pivots, chatter, necking and the like are listed here as they happen.'
      )
    );
  replace(
    parts.list,
    [...warnings]
      .reverse()
      .slice(0, 500)
      .map((one) =>
        el(
          'li',
          {},
          el(
            'button',
            {type: 'button', title: 'Show the kept state nearest to it', onclick: () => show_time(one.time_s)},
            el('span', {class: 'kind'}, one.kind),
            el('span', {class: 'faint'}, `increment ${one.increment} · ${format(one.time_s)} s`)
          ),
          el('p', {}, one.text)
        )
      )
  );
}

/// One that came just now.
export function add_warning(warning) {
  store.set('warnings', [...store.get('warnings'), warning]);
  const toast = el(
    'div',
    {class: 'toast'},
    el(
      'div',
      {},
      el('strong', {}, warning.kind),
      el('span', {class: 'faint'}, ` increment ${warning.increment}`),
      el('p', {}, warning.text)
    ),
    button({icon: 'close', title: 'Hide', kind: 'small quiet'}, () => toast.remove())
  );
  parts.toasts.append(toast);
  while (parts.toasts.children.length > kMostToasts) parts.toasts.firstElementChild.remove();
  setTimeout(() => toast.remove(), 9000);
}
