// SPDX-License-Identifier: GPL-3.0-or-later
// All kept states along the process time: choosing one, playing them, going back to one.
import {may_steer} from './commands.js';
import {button, el, replace, set_text} from './dom.js';
import {find_origin} from './scene_values.js';
import {store} from './store.js';
import {draw_track, find_layout, find_shown, kMarkers} from './timeline_track.js';
import {describe_contact, describe_state} from './state_text.js';
import {act} from './topbar.js';

const parts = {};
let player = null,
  pressed = false;

export function build_timeline(root) {
  parts.canvas = el('canvas', {
    class: 'track',
    id: 'track',
    tabindex: '0',
    role: 'slider',
    'data-keys': true,
    'aria-label': 'Kept state',
    'aria-valuemin': '0',
    'aria-valuemax': '0',
    'aria-valuenow': '0'
  });
  parts.text = el('output', {class: 'where', id: 'where'});
  parts.live = button(
    {text: 'Live', title: 'The newest state, as it comes', key: 'L', id: 'live', pressed: true},
    go_live
  );
  parts.back = button(
    {icon: 'branch', text: 'Branch from here', title: 'Go back to this state and go on from it', id: 'branch'},
    branch
  );
  parts.play = button({icon: 'run', title: 'Play the kept states', id: 'play', kind: 'small'}, toggle_play);
  const legend = el(
    'span',
    {class: 'legend'},
    kMarkers.map(([, , text], i) => el('span', {}, el('i', {class: `marker m${i}`}), text)),
    el('span', {}, el('i', {class: 'marker halt'}), 'halt')
  );
  replace(
    root,
    el(
      'div',
      {class: 'bar'},
      button({icon: 'previous', title: 'Kept state before', key: '[', id: 'before', kind: 'small'}, () => go(-1)),
      parts.play,
      button({icon: 'next', title: 'Next kept state', key: ']', id: 'after', kind: 'small'}, () => go(1)),
      parts.live,
      parts.text,
      el('span', {class: 'grow'}),
      legend,
      parts.back
    ),
    parts.canvas
  );
  attach(parts.canvas);
  new ResizeObserver(draw).observe(parts.canvas);
  store.on(['kept', 'status', 'shown', 'rows', 'theme', 'last_contact'], draw);
}

function attach(canvas) {
  canvas.addEventListener('pointerdown', (event) => {
    pressed = true;
    canvas.setPointerCapture(event.pointerId);
    scrub(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (pressed) scrub(event);
    else hint(event);
  });
  const end = () => {
    if (!pressed) return;
    pressed = false;
    store.set('scrubbing', false);
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('keydown', (event) => {
    const by = {
      ArrowLeft: -1,
      ArrowDown: -1,
      ArrowRight: 1,
      ArrowUp: 1,
      PageUp: 10,
      PageDown: -10,
      Home: -Infinity,
      End: Infinity
    }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    go(by);
  });
}

function find_nearest(event) {
  const box = parts.canvas.getBoundingClientRect(),
    x = event.clientX - box.left,
    y = event.clientY - box.top;
  const layout = find_layout(parts.canvas);
  let best = null,
    best_way = Infinity;
  for (const state of layout.kept) {
    const way = Math.hypot(
      layout.to_x(state.time_s) - x,
      layout.branches.length > 1 ? 2 * (layout.to_y(state.branch) - y) : 0
    );
    if (way < best_way) [best, best_way] = [state, way];
  }
  return best;
}

function scrub(event) {
  const state = find_nearest(event);
  store.set('scrubbing', true);
  if (state) show_state(state);
}

function hint(event) {
  const state = find_nearest(event);
  parts.canvas.title = state ? describe_state(state) : '';
}

export function show_state(state) {
  const shown = store.get('shown');
  if (shown !== 'live' && shown.branch === state.branch && shown.increment === state.increment) return;
  store.set('shown', {branch: state.branch, increment: state.increment});
}

/// The kept state of the present branch nearest to a time.
export function show_time(time) {
  const branch = find_branch(),
    states = store.get('kept').filter((state) => state.branch === branch);
  if (!states.length) return;
  show_state(states.reduce((a, b) => (Math.abs(b.time_s - time) < Math.abs(a.time_s - time) ? b : a)));
}

function find_branch() {
  const shown = store.get('shown');
  return shown === 'live' ? (store.get('status')?.branch ?? 0) : shown.branch;
}

/// `by` kept states on or back.
export function go(by) {
  const shown = store.get('shown'),
    branch = find_branch();
  const states = store.get('kept').filter((state) => state.branch === branch);
  if (!states.length && !find_origin(branch)) return;
  const at = shown === 'live' ? states.length : states.findIndex((state) => state.increment === shown.increment);
  if (at <= 0 && by < 0 && find_origin(branch)) return show_state(find_origin(branch));
  show_state(states[Math.max(0, Math.min(states.length - 1, at + by))]);
}

export function go_live() {
  stop_play();
  store.set('shown', 'live');
}

function toggle_play() {
  if (player) return stop_play();
  const branch = find_branch(),
    states = () => store.get('kept').filter((state) => state.branch === branch);
  const shown = store.get('shown');
  let at = shown === 'live' ? 0 : states().findIndex((state) => state.increment === shown.increment);
  if (at >= states().length - 1) at = 0;
  const next = () => {
    if (at >= states().length) return stop_play();
    show_state(states()[at++]);
  };
  parts.play.setAttribute('aria-pressed', 'true');
  player = setInterval(next, 220);
  next();
}

function stop_play() {
  clearInterval(player);
  player = null;
  parts.play.setAttribute('aria-pressed', 'false');
}

async function branch() {
  const shown = store.get('shown');
  if (shown === 'live') return;
  const reply = await act(`back ${shown.increment}`);
  if (reply.ok) store.set('shown', 'live');
}

function draw() {
  const layout = find_layout(parts.canvas);
  parts.canvas.style.height = `${layout.height}px`;
  update_text(layout, store.get('shown'));
  draw_track(parts.canvas, layout);
}

function update_text(layout, shown) {
  const status = store.get('status'),
    is_live = shown === 'live',
    state = find_shown(layout.kept, shown);
  parts.live.setAttribute('aria-pressed', String(is_live));
  set_text(
    parts.text,
    is_live ? `newest state, ${layout.kept.length} kept${describe_contact()}` : state ? describe_state(state) : ''
  );
  parts.text.title = parts.text.textContent;
  parts.back.hidden = !status?.can_steer;
  parts.back.disabled = is_live || !may_steer() || !state?.can_restore;
  parts.back.title = is_live
    ? 'Choose a kept state first'
    : state?.can_restore
      ? 'Go back to this state and go on from it'
      : 'This state is kept to be looked at only';
  const index = is_live ? layout.kept.length : layout.kept.indexOf(state);
  parts.canvas.setAttribute('aria-valuemax', String(layout.kept.length));
  parts.canvas.setAttribute('aria-valuenow', String(Math.max(0, index)));
  parts.canvas.setAttribute('aria-valuetext', parts.text.textContent);
}
