// SPDX-License-Identifier: GPL-3.0-or-later
// What keys are set to at the moment, as far as scene file, overrides and journal say: shown as a hint in empty fields.
import {get_text} from './api.js';
import {store} from './store.js';

/// key -> value as written; keys that are not in the scene have none (their default holds).
export async function read_scene_values() {
  const read = (name) => get_text('/api/file', {name}).catch(() => '');
  const [scene, overrides, journal] = await Promise.all(['scene.toml', 'overrides.txt', 'journal.jsonl'].map(read));
  const values = read_toml(scene);
  for (const line of overrides.split('\n')) {
    const at = line.indexOf('=');
    if (at > 0) values.set(line.slice(0, at).trim(), line.slice(at + 1).trim());
  }
  for (const command of read_journal(journal).map((line) => line.command ?? '')) {
    const [, key, value] = command.match(/^set (\S+) (.+)$/) ?? [];
    if (key) values.set(key, value);
  }
  return values;
}

/// Enough of TOML for a hint: tables, keys, values over several lines; comments are left out.
function read_toml(text) {
  const values = new Map();
  let table = '',
    key = null,
    value = '';
  for (const raw of text.split('\n')) {
    const line = raw.replace(/("[^"]*")|#.*/g, (all, quoted) => quoted ?? '').trim();
    const heading = key === null ? line.match(/^\[([^[\]]+)\]$/) : null;
    if (heading) {
      table = `${heading[1].trim()}.`;
      continue;
    }
    const start = key === null ? line.match(/^([\w.-]+)\s*=\s*(.*)$/) : null;
    if (start) [key, value] = [table + start[1], start[2]];
    else if (key !== null) value += ` ${line}`;
    if (key === null || count(value, '[') > count(value, ']')) continue;
    values.set(key, value);
    key = null;
  }
  return values;
}

const count = (text, sign) => text.split(sign).length - 1;

export function read_journal(text) {
  return text.split('\n').flatMap((line) => {
    try {
      return [JSON.parse(line)];
    } catch {
      return []; // the line that is being written
    }
  });
}

/// Where branches began: the n-th "back" of the journal began branch n.
export async function load_origins() {
  const lines = read_journal(await get_text('/api/file', {name: 'journal.jsonl'}));
  const origins = new Map();
  for (const {branch, command} of lines) {
    const [, increment] = command?.match(/^back (\d+)$/) ?? [];
    if (increment !== undefined) origins.set(origins.size + 1, {branch, increment: Number(increment)});
  }
  store.set('origins', origins);
}

/// The kept state from which a branch began; undefined when it is not known.
export function find_origin(branch) {
  let origin = store.get('origins').get(branch);
  const goal = origin?.increment;
  while (origin) {
    const found = store.get('kept').find((state) => state.branch === origin.branch && state.increment === goal);
    if (found) return found;
    origin = store.get('origins').get(origin.branch);
  }
  return undefined;
}
