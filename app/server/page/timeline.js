// SPDX-License-Identifier: GPL-3.0-or-later
// All kept states along the process time, one lane a branch, with what happened in them.
import {act} from './topbar.js';
import {may_steer} from './commands.js';
import {button, el, replace, set_text} from './dom.js';
import {dot, line, start_canvas} from './line_chart.js';
import {fixed, tick_text, ticks} from './numbers.js';
import {find_origin} from './scene_values.js';
import {store} from './store.js';
import {colour} from './theme.js';

const kLeft = 14, kRight = 14, kTop = 14, kLane = 16, kAxis = 16;
const kMarkers = [['touched', 'mark-touch', 'touch'], ['slipped', 'mark-slip', 'slip'], ['detached', 'mark-detach', 'lets go']];
const parts = {};
let player = null, pressed = false;

export function build_timeline(root) {
  parts.canvas = el('canvas', {class: 'track', id: 'track', tabindex: '0', role: 'slider', 'data-keys': true, 'aria-label': 'Kept state',
                               'aria-valuemin': '0', 'aria-valuemax': '0', 'aria-valuenow': '0'});
  parts.text = el('output', {class: 'where', id: 'where'});
  parts.live = button({text: 'Live', title: 'The newest state, as it comes', key: 'L', id: 'live', pressed: true}, go_live);
  parts.back = button({icon: 'branch', text: 'Branch from here', title: 'Go back to this state and go on from it', id: 'branch'}, branch);
  parts.play = button({icon: 'run', title: 'Play the kept states', id: 'play', kind: 'small'}, toggle_play);
  const legend = el('span', {class: 'legend'}, kMarkers.map(([, , text], i) => el('span', {}, el('i', {class: `marker m${i}`}), text)),
                    el('span', {}, el('i', {class: 'marker halt'}), 'halt'));
  replace(root, el('div', {class: 'bar'},
      button({icon: 'previous', title: 'Kept state before', key: '[', id: 'before', kind: 'small'}, () => go(-1)), parts.play,
      button({icon: 'next', title: 'Next kept state', key: ']', id: 'after', kind: 'small'}, () => go(1)),
      parts.live, parts.text, el('span', {class: 'grow'}), legend, parts.back), parts.canvas);
  attach(parts.canvas);
  new ResizeObserver(draw).observe(parts.canvas);
  store.on(['kept', 'status', 'shown', 'rows', 'theme', 'last_contact'], draw);
}

function attach(canvas) {
  canvas.addEventListener('pointerdown', (event) => { pressed = true; canvas.setPointerCapture(event.pointerId); scrub(event); });
  canvas.addEventListener('pointermove', (event) => { if (pressed) scrub(event); else hint(event); });
  const end = () => {
    if (!pressed) return;
    pressed = false;
    store.set('scrubbing', false);
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('keydown', (event) => {
    const by = {ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10, Home: -Infinity, End: Infinity}[event.key];
    if (by === undefined) return;
    event.preventDefault();
    go(by);
  });
}

/// Lanes of branches, time to pixels.
function find_layout() {
  const kept = store.get('kept'), status = store.get('status');
  const branches = [...new Set([...kept.map((state) => state.branch), status?.branch ?? 0])].sort((a, b) => a - b);
  const end = Math.max(status?.end_time_s ?? 0, ...kept.map((state) => state.time_s), 1e-9);
  const width = parts.canvas.clientWidth - kLeft - kRight;
  return {kept, branches, end, to_x: (time) => kLeft + (width * time) / end, to_y: (branch) => kTop + kLane * (branches.indexOf(branch) + 0.5)};
}

function find_nearest(event) {
  const box = parts.canvas.getBoundingClientRect(), x = event.clientX - box.left, y = event.clientY - box.top;
  const layout = find_layout();
  let best = null, best_way = Infinity;
  for (const state of layout.kept) {
    const way = Math.hypot(layout.to_x(state.time_s) - x, layout.branches.length > 1 ? 2 * (layout.to_y(state.branch) - y) : 0);
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
  parts.canvas.title = state ? describe(state) : '';
}

function describe(state) {
  const events = [['touched', 'touch'], ['slipped', 'begin to slip'], ['detached', 'let go'], ['retouched', 'touch again']]
    .filter(([name]) => state[name] > 0).map(([name, text]) => `${state[name]} ${text}`).join(', ');
  return `increment ${state.increment}${state.branch ? ` of branch ${state.branch}` : ''}, ${fixed(state.time_s, 4)} s, ` +
         `${fixed(state.pressure_MPa, 3)} MPa (${state.why})${events ? `: ${events}` : ''}`;
}

export function show_state(state) {
  const shown = store.get('shown');
  if (shown !== 'live' && shown.branch === state.branch && shown.increment === state.increment) return;
  store.set('shown', {branch: state.branch, increment: state.increment});
}

/// The kept state of the present branch nearest to a time.
export function show_time(time) {
  const branch = find_branch(), states = store.get('kept').filter((state) => state.branch === branch);
  if (!states.length) return;
  show_state(states.reduce((a, b) => (Math.abs(b.time_s - time) < Math.abs(a.time_s - time) ? b : a)));
}

function find_branch() {
  const shown = store.get('shown');
  return shown === 'live' ? store.get('status')?.branch ?? 0 : shown.branch;
}

/// `by` kept states on or back.
export function go(by) {
  const shown = store.get('shown'), branch = find_branch();
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
  const branch = find_branch(), states = () => store.get('kept').filter((state) => state.branch === branch);
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
  const layout = find_layout(), shown = store.get('shown'), status = store.get('status');
  parts.canvas.style.height = `${kTop + kAxis + kLane * Math.min(4, layout.branches.length)}px`;
  update_text(layout, shown);
  const context = start_canvas(parts.canvas);
  if (!context || !status) return;
  draw_axis(context, layout);
  for (const branch of layout.branches) draw_lane(context, layout, branch, status);
  const now = layout.to_x(status.time_s), y = layout.to_y(status.branch);
  context.fillStyle = colour(shown === 'live' ? 'accent' : 'faint');
  context.beginPath();
  context.moveTo(now, y - 6); context.lineTo(now + 7, y); context.lineTo(now, y + 6);
  context.fill();
  const state = find_shown(layout.kept, shown);
  if (state) draw_cursor(context, layout, state);
}

/// What happened last, while it is watched.
function describe_contact() {
  const last = store.get('last_contact');
  if (!last) return '';
  const words = [['touched', 'touched'], ['slipped', 'began to slip'], ['detached', 'let go'], ['retouched', 'touched again']]
    .filter(([name]) => last[name] > 0).map(([name, text]) => `${last[name]} ${text}`);
  return words.length ? ` · increment ${last.increment}: ${words.join(', ')}` : '';
}

function find_shown(kept, shown) {
  return shown === 'live' ? null : kept.find((state) => state.branch === shown.branch && state.increment === shown.increment);
}

function draw_cursor(context, layout, state) {
  const x = layout.to_x(state.time_s), y = layout.to_y(state.branch);
  context.strokeStyle = colour('accent');
  context.fillStyle = colour('accent');
  context.lineWidth = 1.5;
  line(context, x, 2, x, parts.canvas.clientHeight - kAxis);
  dot(context, x, y, 5);
}

function draw_axis(context, layout) {
  const bottom = parts.canvas.clientHeight - kAxis;
  context.strokeStyle = colour('grid');
  context.fillStyle = colour('faint');
  context.lineWidth = 1;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const marks = ticks(0, layout.end, Math.max(3, Math.floor(parts.canvas.clientWidth / 110)));
  for (const mark of marks) {
    const x = Math.round(layout.to_x(mark)) + 0.5;
    line(context, x, kTop - 6, x, bottom + 3);
    context.textAlign = mark === 0 ? 'left' : mark === marks.at(-1) && x > parts.canvas.clientWidth - 30 ? 'right' : 'center';
    context.fillText(`${tick_text(mark, marks[1] - marks[0] || 1)}${mark === 0 ? ' s' : ''}`, x, bottom + 4);
  }
}

function draw_lane(context, layout, branch, status) {
  const states = layout.kept.filter((state) => state.branch === branch), y = layout.to_y(branch);
  const end = branch === status.branch ? status.time_s : states.at(-1)?.time_s ?? 0;
  const origin = find_origin(branch), start = branch === 0 ? 0 : origin?.time_s ?? states[0]?.time_s ?? end;
  context.strokeStyle = colour(branch === status.branch ? 'lane-now' : 'lane');
  context.lineWidth = 4;
  line(context, layout.to_x(start), y, Math.max(layout.to_x(end), layout.to_x(start) + 0.5), y);
  if (branch > 0) {
    context.lineWidth = 1.5;
    line(context, layout.to_x(start), y, layout.to_x(start), origin ? layout.to_y(origin.branch) : y - kLane);
  }
  for (const state of states) draw_state(context, layout.to_x(state.time_s), y, state);
}

function draw_state(context, x, y, state) {
  context.fillStyle = colour('dot');
  dot(context, x, y, 2.4);
  kMarkers.forEach(([name, tint], i) => {
    if (!(state[name] > 0)) return;
    context.fillStyle = colour(tint);
    context.fillRect(x - 1.5, y - 6.5 - i * 3.2, 3, 3);
  });
  if (state.why !== 'halt') return;
  context.strokeStyle = colour('text');
  context.lineWidth = 1.2;
  context.strokeRect(x - 4, y - 4, 8, 8);
}

function update_text(layout, shown) {
  const status = store.get('status'), is_live = shown === 'live', state = find_shown(layout.kept, shown);
  parts.live.setAttribute('aria-pressed', String(is_live));
  set_text(parts.text, is_live ? `newest state, ${layout.kept.length} kept${describe_contact()}` : state ? describe(state) : '');
  parts.text.title = parts.text.textContent;
  parts.back.hidden = !status?.can_steer;
  parts.back.disabled = is_live || !may_steer() || !state?.can_restore;
  parts.back.title = is_live ? 'Choose a kept state first' : state?.can_restore ? 'Go back to this state and go on from it'
                                                                                : 'This state is kept to be looked at only';
  const index = is_live ? layout.kept.length : layout.kept.indexOf(state);
  parts.canvas.setAttribute('aria-valuemax', String(layout.kept.length));
  parts.canvas.setAttribute('aria-valuenow', String(Math.max(0, index)));
  parts.canvas.setAttribute('aria-valuetext', parts.text.textContent);
}
