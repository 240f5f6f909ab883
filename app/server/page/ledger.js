// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of detachment: what let go, when, and whether to believe it. A click flies there and then.
import {get} from './api.js';
import {button, el, replace, set_text} from './dom.js';
import {format} from './numbers.js';
import {sort_table} from './sort_table.js';
import {store} from './store.js';
import {show_time} from './timeline.js';

const number = (value) => format(value, 4),
  short = (value) => format(value, 3);
const verdict = {key: 'verdict', caption: 'Verdict', kind: (row) => `verdict ${row.verdict}`};
const gap = {
  key: 'gap_reached_mm',
  caption: 'Gap mm',
  title: 'Largest gap reached',
  format: (value, row) => (row.left_reach ? 'open' : short(value))
};
const kPatches = [
  {key: 'patch', caption: 'Patch'},
  {key: 'node_count', caption: 'Nodes'},
  verdict,
  {key: 'first_increment', caption: 'Incr.', title: 'First increment'},
  {key: 'first_time_s', caption: 'Time s', format: number},
  gap,
  {key: 'came_back', caption: 'Back', title: 'Nodes that came back'},
  {key: 'tool', caption: 'Tool'}
];
const kEpisodes = [
  {key: 'node', caption: 'Node'},
  verdict,
  {key: 'let_go_increment', caption: 'Incr.'},
  {key: 'let_go_time_s', caption: 'Time s', format: number},
  {key: 'release_force_N', caption: 'Force N', title: 'Normal force as it let go', format: short},
  gap,
  {key: 'toggles', caption: 'Togg.', title: 'Lettings go and returns so far'},
  {key: 'tool', caption: 'Tool'}
];
const parts = {};
const sorts = {patches: {key: 'first_increment', is_down: false}, episodes: {key: 'let_go_increment', is_down: false}};
let ledger = {patches: [], episodes: []},
  kind = 'patches',
  loaded_for = '',
  fly = () => {};

/// fly_there(place, size [mm], normal)
export function build_ledger(root, fly_there) {
  fly = fly_there;
  parts.kind = el(
    'select',
    {
      id: 'ledger-kind',
      'aria-label': 'Rows',
      onchange: () => {
        kind = parts.kind.value;
        draw();
      }
    },
    el('option', {value: 'patches'}, 'Patches'),
    el('option', {value: 'episodes'}, 'Nodes')
  );
  parts.filter = el(
    'select',
    {id: 'ledger-filter', 'aria-label': 'Verdict', onchange: draw},
    ['all verdicts', 'physical', 'noise', 'chatter'].map((name, i) => el('option', {value: i ? name : ''}, name))
  );
  parts.note = el('p', {class: 'faint', role: 'status'});
  parts.table = el('div', {class: 'scroll'});
  parts.reason = el('div', {class: 'reason', id: 'ledger-reason', role: 'status', hidden: true});
  replace(
    root,
    el(
      'div',
      {class: 'row'},
      parts.kind,
      parts.filter,
      el('span', {class: 'grow'}),
      button({text: 'Read again', title: 'Read the ledger of the run as it is now', id: 'ledger-load'}, () =>
        load(true)
      )
    ),
    parts.note,
    parts.reason,
    parts.table
  );
  store.on(['tab', 'status'], () => load(false));
}

let is_loading = false,
  loaded_at = 0;
async function load(is_asked) {
  const status = store.get('status');
  if (store.get('tab') !== 'ledger' || !status || is_loading) return;
  const now = `${status.branch}.${status.increment}`;
  const is_due = now !== loaded_for && (status.phase !== 'running' || Date.now() - loaded_at > 5000);
  if (!is_asked && !is_due) return;
  is_loading = true;
  try {
    ledger = await get('/api/ledger');
    loaded_for = now;
    loaded_at = Date.now();
    draw();
  } catch (error) {
    loaded_for = now;
    set_text(parts.note, `No ledger: ${error.message}`);
  }
  is_loading = false;
}

function draw() {
  const is_patches = kind === 'patches',
    wanted = parts.filter.value;
  const all = is_patches ? ledger.patches : ledger.episodes.filter((row) => row.let_go_increment !== null);
  const rows = all.filter((row) => !wanted || row.verdict === wanted);
  const count = (name) => all.filter((row) => row.verdict === name).length;
  set_text(
    parts.note,
    all.length
      ? `${all.length} ${is_patches ? (all.length === 1 ? 'patch' : 'patches') : all.length === 1 ? 'letting go' : 'lettings go'}: ${count('physical')} physical, ${count('noise')} noise, ${count('chatter')} chatter`
      : 'Nothing has let go so far.'
  );
  const is_one_tool = store.get('model')?.tools.length === 1;
  const columns = (is_patches ? kPatches : kEpisodes).filter((column) => column.key !== 'tool' || !is_one_tool);
  replace(
    parts.table,
    rows.length ? sort_table({id: 'ledger-table', columns, rows: rows.slice(0, 1000), sort: sorts[kind], choose}) : null
  );
}

function choose(row) {
  const is_patch = 'node_count' in row;
  const place = row.place_mm ?? row.centre_mm ?? [row.x_mm, row.y_mm, row.z_mm];
  fly_there(row, place, is_patch);
  show_time(is_patch ? row.first_time_s : row.let_go_time_s);
  store.set('selection', is_patch ? {nodes: row.nodes, summary: {}, is_patch: true} : {node: row.node});
  show_reason(row, is_patch);
}

/// From the side where it lay on the tool, as the kept state before knows it.
async function fly_there(row, place, is_patch) {
  const size = is_patch ? Math.sqrt(Math.max(0, row.area_mm2 ?? 0)) : 0,
    node = is_patch ? row.nodes[0] : row.node;
  const increment = is_patch ? row.first_increment : row.let_go_increment,
    {branch} = store.get('status');
  const before = store
    .get('kept')
    .filter((state) => state.branch === branch && state.increment < increment)
    .at(-1);
  const values = before
    ? await get(`/api/node/${node}`, {state: `${before.branch}.${before.increment}`}).catch(() => null)
    : null;
  fly(place, size, values?.tool_normal ?? null);
}

/// Why it is judged as it is: of a patch, the words of its nodes' episodes.
function show_reason(row, is_patch) {
  const reasons = is_patch ? ledger.episodes.filter((one) => one.patch === row.patch && one.reason) : [row];
  const title = is_patch ? `Patch ${row.patch}: ${row.verdict}` : `Node ${row.node}: ${row.verdict}`;
  const details = is_patch
    ? `Increments ${row.first_increment} to ${row.last_increment}; ${(row.causes ?? []).join(', ')} while ${(row.drives ?? []).join(', ')}; limited by ${[...new Set(row.limited_by ?? [])].join(', ')}.`
    : `${row.cause ?? ''} while ${row.drive ?? ''}; touched at ${format(row.touched_time_s)} s, let go at ${format(row.let_go_time_s)} s${row.back_time_s !== null && row.back_time_s !== undefined ? `, back at ${format(row.back_time_s)} s` : ''}.`;
  replace(
    parts.reason,
    el('strong', {}, title),
    el('p', {}, details),
    el(
      'ul',
      {},
      reasons.slice(0, 6).map((one) => el('li', {}, is_patch ? `Node ${one.node}: ${one.reason}` : one.reason))
    ),
    reasons.length > 6 ? el('p', {class: 'faint'}, `and ${reasons.length - 6} more nodes (choose "Nodes" above)`) : null
  );
  parts.reason.hidden = false;
}
