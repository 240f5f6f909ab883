// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of a rectangle, a row each; values of those that are shown are asked for a few at a time.
import {get} from './api.js';
import {el} from './dom.js';
import {format} from './numbers.js';
import {sort_table} from './sort_table.js';
import {state_name, store} from './store.js';

const kMost = 60;
const kColumns = [
  ['node', 'Node'],
  ['contact', 'Contact'],
  ['thickness_mm', 't mm'],
  ['plastic_strain', 'Strain'],
  ['contact_pressure_MPa', 'p MPa'],
  ['gap_mm', 'Gap mm']
];

export function make_node_table(nodes) {
  const shown = nodes.slice(0, kMost).map((node) => (typeof node === 'object' ? node : {node}));
  const holder = el('div', {});
  const draw = () =>
    holder.replaceChildren(
      sort_table({
        id: 'many-nodes',
        columns: kColumns.map(([key, caption]) => ({
          key,
          caption,
          format: (value) => (typeof value === 'string' ? value : key === 'node' ? String(value) : format(value, 3))
        })),
        rows: shown,
        choose: (row) => store.set('selection', {node: row.node})
      })
    );
  draw();
  fill(shown, state_name(), holder).then(draw);
  return el(
    'div',
    {},
    holder,
    nodes.length > kMost ? el('p', {class: 'faint'}, `The first ${kMost} of ${nodes.length} nodes.`) : null
  );
}

/// Two requests at a time: pictures and commands have the right of way.
async function fill(rows, state, holder) {
  const waiting = rows.filter((row) => row.thickness_mm === undefined);
  const work = async () => {
    for (let row = waiting.shift(); row; row = waiting.shift()) {
      if (rows.length > 1 && !holder.isConnected && waiting.length < rows.length - 4) return;
      try {
        Object.assign(row, await get(`/api/node/${row.node}`, {state}));
      } catch {
        return;
      }
    }
  };
  await Promise.all([work(), work()]);
}
