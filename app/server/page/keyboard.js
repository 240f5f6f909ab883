// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of the whole page. Fields keep their own; so do lists, tables and sliders that have the focus.
import {kStandardViews, orbit, pan, zoom_at} from './camera.js';
import {show_help} from './help.js';
import {store} from './store.js';
import {fit, set_direction} from './toolbar.js';
import {toggle_theme} from './theme.js';
import {step, toggle_run} from './topbar.js';

const kTurn = 12; // [px] of mouse way that an arrow key is worth
const kMove = 24;

const change = (make) => store.set('camera', make(store.get('camera')));

/// actions: go(by), live(), console(), pick_middle().
export function start_keyboard(actions) {
  const arrows = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
  const keys = {
    ' ': toggle_run,
    s: step,
    u: () => document.getElementById('until').click(),
    f: fit,
    l: actions.live,
    t: toggle_theme,
    '[': () => actions.go(-1),
    ']': () => actions.go(1),
    '?': show_help,
    '/': actions.console,
    Escape: () => store.set('selection', null),
    '+': () => change((camera) => zoom_at(camera, 1.15)),
    '=': () => change((camera) => zoom_at(camera, 1.15)),
    '-': () => change((camera) => zoom_at(camera, 1 / 1.15))
  };
  for (const view of kStandardViews) keys[view.key] = () => set_direction(view);

  document.addEventListener('keydown', (event) => {
    if (
      event.defaultPrevented ||
      event.ctrlKey ||
      event.metaKey ||
      event.altKey ||
      document.querySelector('dialog[open]')
    )
      return;
    const target = event.target;
    if (target.matches('input:not([type=range]), select, textarea')) return;
    const is_control = target.closest('button, a, input, summary, [role=tab], [data-keys]');
    if (is_control && (event.key === ' ' || event.key === 'Enter' || event.key in arrows)) return;
    if (event.key === 'Enter' && target.matches('.surface')) return actions.pick_middle();
    if (event.key in arrows) {
      const [x, y] = arrows[event.key];
      if (event.shiftKey) change((camera) => pan(camera, x * kMove, y * kMove, 500));
      else change((camera) => orbit(camera, x * kTurn, y * kTurn));
    } else {
      const action = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
      if (!action) return;
      action();
    }
    event.preventDefault();
  });
}
