// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps tables of the run up to date: asked for again when the status says that they have grown.
import {get} from './api.js';
import {load_origins} from './scene_values.js';
import {store} from './store.js';

const kPace = 700; // [ms] between two questions for the same table

/// Runs `task` when called, but never twice at once and no more often than the pace allows.
function pace(task) {
  let is_busy = false,
    is_due = false;
  const run = async () => {
    if (is_busy) {
      is_due = true;
      return;
    }
    is_busy = true;
    is_due = false;
    try {
      await task();
    } catch {
      // Shown by the banner; asked for again at the next change.
    }
    setTimeout(() => {
      is_busy = false;
      if (is_due) run();
    }, kPace);
  };
  return run;
}

const load_timeline = pace(async () => {
  const {kept} = await get('/api/timeline');
  if (kept.some((state) => state.branch > 0) || store.get('status')?.branch > 0) await load_origins().catch(() => {});
  store.set('kept', kept);
});

let rows_of = null;
const load_history = pace(async () => {
  const branch = store.get('status')?.branch,
    old = rows_of === branch ? store.get('rows') : [];
  const from = old.length ? old.at(-1).increment + 1 : 0;
  const fresh = (await get('/api/history', {from})).rows;
  rows_of = branch;
  if (fresh.length || !old.length)
    store.set('rows', [...old, ...fresh.filter((row) => !old.length || row.increment > old.at(-1).increment)]);
});

const load_warnings = pace(async () => store.set('warnings', (await get('/api/warnings')).warnings));

export async function load_all() {
  store.set('model', await get('/api/model')); // the status comes by itself with the event stream
  rows_of = null;
  load_timeline();
  load_history();
  load_warnings();
}

/// Follows the status.
export function follow_status() {
  let before = {};
  store.on('status', (status) => {
    if (status.n_kept !== before.n_kept || status.branch !== before.branch) load_timeline();
    if (status.increment !== before.increment || status.branch !== before.branch) load_history();
    if (status.branch !== before.branch && before.branch !== undefined) load_warnings();
    before = status;
  });
}
