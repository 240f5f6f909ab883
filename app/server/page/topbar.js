// SPDX-License-Identifier: GPL-3.0-or-later
// The top line: what the run does, how far it is, and who steers it.
import {may_steer, send, steer} from './commands.js';
import {ask, button, el, icon, replace, set_text} from './dom.js';
import {show_help} from './help.js';
import {duration, fixed} from './numbers.js';
import {store} from './store.js';
import {toggle_theme} from './theme.js';
import {make_until} from './until.js';

const parts = {};
const kPhases = {paused: 'Paused', running: 'Running', ended: 'Ended'};

export function build_topbar(root) {
  parts.title = el('span', {class: 'title', id: 'title'});
  parts.phase_name = el('strong', {});
  parts.phase_why = el('small', {class: 'faint'});
  parts.phase = el(
    'span',
    {class: 'phase', id: 'phase', role: 'status'},
    el('span', {}, parts.phase_name, parts.phase_why)
  );
  parts.run = button(
    {icon: 'run', text: 'Run', title: 'Run or pause', key: 'Space', id: 'run', kind: 'primary'},
    toggle_run
  );
  parts.step = button({icon: 'step', text: 'Step', title: 'One increment', key: 'S', id: 'step'}, step);
  parts.stop = button({icon: 'stop', text: 'Stop', title: 'End the run for good', id: 'stop'}, stop);
  parts.until = make_until((text) => act(text));
  parts.readout = {};
  parts.wheel = el('span', {class: 'wheel', id: 'wheel'});
  parts.progress = el('progress', {max: 1, value: 0, id: 'progress', 'aria-label': 'Share of the process time'});
  parts.reply = el('div', {id: 'reply', hidden: true});
  parts.steering = el(
    'div',
    {class: 'group steering', role: 'group', 'aria-label': 'Steering'},
    parts.run,
    parts.step,
    parts.until.root,
    parts.stop
  );
  replace(
    root,
    el(
      'div',
      {class: 'bar'},
      el('div', {class: 'name'}, el('strong', {}, 'Hydroscope'), parts.title),
      parts.steering,
      parts.phase,
      el(
        'dl',
        {class: 'readouts'},
        make_readout('increment', 'Increment'),
        make_readout('time', 'Time'),
        make_readout('pressure', 'Pressure'),
        make_readout('contact', 'In contact'),
        make_readout('solver', 'Solver')
      ),
      el('span', {class: 'grow'}),
      parts.wheel,
      el(
        'div',
        {class: 'group'},
        button({icon: 'theme', title: 'Light or dark', id: 'theme', kind: 'quiet'}, toggle_theme),
        button({text: '?', title: 'Help', id: 'help', kind: 'quiet'}, show_help)
      )
    ),
    parts.progress,
    parts.reply
  );
  store.on(['status', 'connection', 'model'], update);
}

function make_readout(name, caption) {
  parts.readout[name] = el('dd', {id: `readout-${name}`}, '–');
  return el('div', {class: name}, el('dt', {}, caption), parts.readout[name]);
}

/// Sends a command and shows what came of it under the buttons. Errors stay until the next command.
export async function act(text) {
  const reply = await send(text);
  // What went well shows by itself in the phase and the numbers.
  if (!reply.ok) show_reply('error', reply.text.startsWith(text) ? reply.text : `${text}: ${reply.text}`);
  else if (text.startsWith('back')) show_reply('info', reply.text);
  else parts.reply.hidden = true;
  return reply;
}

function show_reply(kind, text) {
  replace(
    parts.reply,
    el('span', {}, text),
    button({icon: 'close', title: 'Hide this message', kind: 'small quiet'}, () => {
      parts.reply.hidden = true;
    })
  );
  parts.reply.className = kind;
  parts.reply.setAttribute('role', kind === 'error' ? 'alert' : 'status');
  parts.reply.hidden = false;
  clearTimeout(parts.timer);
  if (kind !== 'error')
    parts.timer = setTimeout(() => {
      parts.reply.hidden = true;
    }, 4000);
}

export function toggle_run() {
  if (!may_steer()) return tell_why_not();
  const is_running = store.get('status').phase === 'running';
  if (!is_running) store.set('shown', 'live');
  act(is_running ? 'pause' : 'run');
}

export function step() {
  if (!may_steer()) return tell_why_not();
  store.set('shown', 'live');
  act('step');
}

async function stop() {
  const answer = await ask(
    'End the run?',
    'The increment at work is finished and the summary is written. A stopped run cannot go on.',
    [
      ['', 'Keep it'],
      ['stop', 'End it', 'danger']
    ]
  );
  if (answer === 'stop') act('stop');
}

/// A key that does nothing must say why.
function tell_why_not() {
  const status = store.get('status');
  if (!status || store.get('connection') !== 'open') show_reply('error', 'There is no connection to the program.');
  else if (!status.can_steer) show_reply('error', 'This is a finished run; it can only be looked at.');
  else show_reply('error', 'Another viewer steers. Take the wheel first.');
}

async function take_wheel() {
  let reply = await steer(true);
  if (!reply.ok && reply.status === 409) {
    const answer = await ask(
      'Take the wheel?',
      'Another viewer steers this run. It goes on watching, and its buttons are disabled.',
      [
        ['', 'Leave it'],
        ['take', 'Take the wheel', 'primary']
      ]
    );
    if (answer !== 'take') return;
    reply = await steer(true, true);
  }
  show_reply(reply.ok ? 'info' : 'error', reply.text);
}

async function give_wheel() {
  const reply = await steer(false);
  show_reply(reply.ok ? 'info' : 'error', reply.text);
}

function update() {
  const status = store.get('status');
  if (!status) return;
  const phase =
    status.phase === 'ended' && status.outcome ? `Ended: ${status.outcome}` : (kPhases[status.phase] ?? status.phase);
  set_text(parts.title, status.title);
  parts.title.title = status.title;
  set_text(parts.phase_name, phase);
  const why = status.message?.toLowerCase() === phase.toLowerCase() ? '' : (status.message ?? '');
  set_text(parts.phase_why, status.until ? `until ${status.until}` : why);
  parts.phase.dataset.phase = status.phase;
  parts.phase.title = parts.phase_why.textContent;
  set_text(parts.readout.increment, String(status.increment) + (status.branch ? ` · branch ${status.branch}` : ''));
  set_text(parts.readout.time, `${fixed(status.time_s, 4)} / ${status.end_time_s} s`);
  set_text(parts.readout.pressure, `${fixed(status.pressure_MPa, 3)} MPa`);
  set_text(parts.readout.contact, `${status.n_contact} nodes`);
  set_text(parts.readout.solver, duration(status.solver_s));
  parts.progress.value = status.end_time_s > 0 ? Math.min(1, status.time_s / status.end_time_s) : 0;
  document.title = `${phase} · ${status.title}`;
  update_buttons(status);
  update_wheel(status);
}

function update_buttons(status) {
  const is_running = status.phase === 'running',
    can = may_steer();
  parts.steering.hidden = !status.can_steer;
  replace(parts.run, icon(is_running ? 'pause' : 'run'), el('span', {}, is_running ? 'Pause' : 'Run'));
  parts.run.disabled = !can || status.phase === 'ended';
  parts.step.disabled = !can || status.phase !== 'paused';
  parts.until.set_disabled(!can || status.phase === 'ended');
  parts.stop.disabled = !can || status.phase === 'ended';
  parts.steering.title = can ? '' : 'Another viewer steers: take the wheel first';
}

function update_wheel(status) {
  const key = `${status.can_steer}|${status.you_steer}|${status.steering_viewer}|${status.viewers}`;
  if (parts.wheel.dataset.key === key) return;
  parts.wheel.dataset.key = key;
  const watching = status.viewers > 1 ? `${status.viewers} viewers` : '';
  if (!status.can_steer) return replace(parts.wheel, el('span', {class: 'chip'}, 'Finished run, to be looked at'));
  if (status.you_steer)
    return replace(
      parts.wheel,
      el('span', {class: 'chip mine'}, icon('wheel'), watching ? `You steer · ${watching}` : 'You steer'),
      status.viewers > 1
        ? button({text: 'Let go', title: 'Give the wheel away', id: 'give', kind: 'small'}, give_wheel)
        : null
    );
  replace(
    parts.wheel,
    el('span', {class: 'chip'}, status.steering_viewer ? 'Another viewer steers' : 'Nobody steers'),
    button(
      {icon: 'wheel', text: 'Take the wheel', title: 'Steer from this page', id: 'take', kind: 'primary'},
      take_wheel
    )
  );
}
