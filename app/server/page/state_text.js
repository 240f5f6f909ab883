// SPDX-License-Identifier: GPL-3.0-or-later
// Kept states and contact events in words.
import {fixed} from './numbers.js';
import {store} from './store.js';

export function describe_state(state) {
  const events = [
    ['touched', 'touch'],
    ['slipped', 'begin to slip'],
    ['detached', 'let go'],
    ['retouched', 'touch again']
  ]
    .filter(([name]) => state[name] > 0)
    .map(([name, text]) => `${state[name]} ${text}`)
    .join(', ');
  return (
    `increment ${state.increment}${state.branch ? ` of branch ${state.branch}` : ''}, ${fixed(state.time_s, 4)} s, ` +
    `${fixed(state.pressure_MPa, 3)} MPa (${state.why})${events ? `: ${events}` : ''}`
  );
}

/// What happened last, while it is watched.
export function describe_contact() {
  const last = store.get('last_contact');
  if (!last) return '';
  const words = [
    ['touched', 'touched'],
    ['slipped', 'began to slip'],
    ['detached', 'let go'],
    ['retouched', 'touched again']
  ]
    .filter(([name]) => last[name] > 0)
    .map(([name, text]) => `${last[name]} ${text}`);
  return words.length ? ` · increment ${last.increment}: ${words.join(', ')}` : '';
}
