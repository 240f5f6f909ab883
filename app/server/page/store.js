// SPDX-License-Identifier: GPL-3.0-or-later
// What the page knows, in one place: whoever wants to hear of a change says of which.

class Store {
  #values = {
    connection: 'connecting', // connecting | open | lost | refused
    status: null, // newest of /api/status or the event stream
    model: null,
    kept: [], // /api/timeline
    rows: [], // /api/history of the present branch
    warnings: [],
    log: [], // what was commanded from this page and what came of it
    shown: 'live', // or {branch, increment}
    camera: null,
    display: null,
    slots: {a: null, b: null},
    two_views: false,
    active: 'a',
    selection: null, // {node} or {nodes, summary}
    theme: 'light',
    tab: 'inspect',
    scrubbing: false,
    origins: new Map(), // branch -> {branch, increment} that it began from
    last_contact: null // newest increment with contact events
  };
  #listeners = new Map();

  get(key) {
    return this.#values[key];
  }

  set(key, value) {
    if (Object.is(this.#values[key], value)) return;
    this.#values[key] = value;
    for (const listener of this.#listeners.get(key) ?? []) listener(value);
  }

  /// Some fields of a value that is an object.
  patch(key, fields) {
    this.set(key, {...this.#values[key], ...fields});
  }

  /// Calls `listener` on each change of any of the keys.
  on(keys, listener) {
    for (const key of [keys].flat()) {
      if (!(key in this.#values)) throw new Error(`store has no ${key}`);
      if (!this.#listeners.has(key)) this.#listeners.set(key, new Set());
      this.#listeners.get(key).add(listener);
    }
  }
}

export const store = new Store();

/// state= of the API for what is shown.
export function state_name(shown = store.get('shown')) {
  return shown === 'live' ? 'live' : `${shown.branch}.${shown.increment}`;
}
