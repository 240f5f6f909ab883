// SPDX-License-Identifier: GPL-3.0-or-later
// The track of the timeline: one lane a branch, a dot a kept state, marks for what happened since the one before.
import {dot, line, start_canvas} from './line_chart.js';
import {tick_text, ticks} from './numbers.js';
import {find_origin} from './scene_values.js';
import {store} from './store.js';
import {colour} from './theme.js';

const kLeft = 14,
  kRight = 14,
  kTop = 14,
  kLane = 16,
  kAxis = 16;
export const kMarkers = [
  ['touched', 'mark-touch', 'touch'],
  ['slipped', 'mark-slip', 'slip'],
  ['detached', 'mark-detach', 'lets go']
];

/// Lanes of branches, time to pixels.
export function find_layout(canvas) {
  const kept = store.get('kept'),
    status = store.get('status');
  const branches = [...new Set([...kept.map((state) => state.branch), status?.branch ?? 0])].sort((a, b) => a - b);
  const end = Math.max(status?.end_time_s ?? 0, ...kept.map((state) => state.time_s), 1e-9);
  const width = canvas.clientWidth - kLeft - kRight;
  const lane = (kLane * Math.min(4, branches.length)) / branches.length; // many branches stand closer
  return {
    kept,
    branches,
    end,
    height: kTop + kAxis + kLane * Math.min(4, branches.length),
    to_x: (time) => kLeft + (width * time) / end,
    to_y: (branch) => kTop + lane * (branches.indexOf(branch) + 0.5)
  };
}

/// The kept state that is looked at; null when it is the newest one.
export function find_shown(kept, shown) {
  return shown === 'live'
    ? null
    : kept.find((state) => state.branch === shown.branch && state.increment === shown.increment);
}

/// Axis, lanes, where the run is, and what is looked at.
export function draw_track(canvas, layout) {
  const status = store.get('status'),
    shown = store.get('shown');
  const context = start_canvas(canvas);
  if (!context || !status) return;
  draw_axis(context, layout, canvas);
  for (const branch of layout.branches) draw_lane(context, layout, branch, status);
  const now = layout.to_x(status.time_s),
    y = layout.to_y(status.branch);
  context.fillStyle = colour(shown === 'live' ? 'accent' : 'faint');
  context.beginPath();
  context.moveTo(now, y - 6);
  context.lineTo(now + 7, y);
  context.lineTo(now, y + 6);
  context.fill();
  const state = find_shown(layout.kept, shown);
  if (state) draw_cursor(context, layout, state, canvas);
}

function draw_cursor(context, layout, state, canvas) {
  const x = layout.to_x(state.time_s),
    y = layout.to_y(state.branch);
  context.strokeStyle = colour('accent');
  context.fillStyle = colour('accent');
  context.lineWidth = 1.5;
  line(context, x, 2, x, canvas.clientHeight - kAxis);
  dot(context, x, y, 5);
}

function draw_axis(context, layout, canvas) {
  const bottom = canvas.clientHeight - kAxis;
  context.strokeStyle = colour('grid');
  context.fillStyle = colour('faint');
  context.lineWidth = 1;
  context.textAlign = 'center';
  context.textBaseline = 'top';
  const marks = ticks(0, layout.end, Math.max(3, Math.floor(canvas.clientWidth / 110)));
  for (const mark of marks) {
    const x = Math.round(layout.to_x(mark)) + 0.5;
    line(context, x, kTop - 6, x, bottom + 3);
    context.textAlign = mark === 0 ? 'left' : mark === marks.at(-1) && x > canvas.clientWidth - 30 ? 'right' : 'center';
    context.fillText(`${tick_text(mark, marks[1] - marks[0] || 1)}${mark === 0 ? ' s' : ''}`, x, bottom + 4);
  }
}

function draw_lane(context, layout, branch, status) {
  const states = layout.kept.filter((state) => state.branch === branch),
    y = layout.to_y(branch);
  const end = branch === status.branch ? status.time_s : (states.at(-1)?.time_s ?? 0);
  const origin = find_origin(branch),
    start = branch === 0 ? 0 : (origin?.time_s ?? states[0]?.time_s ?? end);
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
