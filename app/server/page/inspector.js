// SPDX-License-Identifier: GPL-3.0-or-later
// What was picked: values of a node and their history, or a summary of many nodes.
import {get} from './api.js';
import {button, el, replace, set_text} from './dom.js';
import {LineChart} from './line_chart.js';
import {find_marked} from './live_charts.js';
import {make_node_table} from './node_table.js';
import {format} from './numbers.js';
import {state_name, store} from './store.js';
import {show_time} from './timeline.js';
import {act} from './topbar.js';

const kValues = [
  ['contact', 'Contact', ''],
  ['tool', 'Tool', ''],
  ['gap_mm', 'Gap to the tool', 'mm'],
  ['normal_force_N', 'Normal force', 'N'],
  ['margin_N', 'Margin to release', 'N'],
  ['release_threshold_N', 'Lets go at a tension of', 'N'],
  ['friction_N', 'Friction force', 'N'],
  ['contact_pressure_MPa', 'Contact pressure', 'MPa'],
  ['slip_mm', 'Slid so far', 'mm'],
  ['let_go_time_s', 'Last let go at', 's'],
  ['toggles', 'Lettings go and returns', ''],
  ['thickness_mm', 'Wall thickness', 'mm'],
  ['plastic_strain', 'Plastic strain', ''],
  ['position_mm', 'Position', 'mm'],
  ['displacement_mm', 'Displacement', 'mm'],
  ['tool_normal', "Tool's normal", '']
];
const kHistories = [
  ['thickness_mm', 'Wall thickness [mm]', 'line-1'],
  ['plastic_strain', 'Plastic strain [-]', 'line-4'],
  ['gap_mm', 'Gap [mm]', 'line-2'],
  ['normal_force_N', 'Normal force [N]', 'line-3'],
  ['margin_N', 'Margin to release [N]', 'line-5'],
  ['slip_mm', 'Slid so far [mm]', 'line-3']
];
const kClasses = ['free', 'stick', 'slip', 'detached now'];
const parts = {charts: new Map()};
let asked = 0;

export function build_inspector(root) {
  parts.number = el('input', {
    type: 'text',
    inputmode: 'numeric',
    id: 'node-number',
    'aria-label': 'Node number',
    placeholder: 'node',
    autocomplete: 'off'
  });
  parts.error = el('p', {class: 'error', role: 'alert', hidden: true});
  parts.body = el('div', {id: 'inspect-body'});
  const form = el(
    'form',
    {
      class: 'row',
      onsubmit: (event) => {
        event.preventDefault();
        enter_number();
      }
    },
    el('label', {for: 'node-number'}, 'Node'),
    parts.number,
    el('button', {type: 'submit'}, 'Show'),
    el('span', {class: 'grow'}),
    button({text: 'Clear', title: 'Let go of the selection', kind: 'quiet'}, () => store.set('selection', null))
  );
  replace(root, form, parts.error, parts.body);
  for (const [name, title] of kHistories) parts.charts.set(name, new LineChart({title, height: 92, pick: show_time}));
  store.on(['selection', 'shown'], load);
  store.on('status', load_with_run);
  store.on('kept', () => load_history());
  store.on('tab', load);
  load();
}

function enter_number() {
  const node = Number(parts.number.value),
    count = store.get('model')?.nodes ?? 0;
  const is_good = parts.number.value.trim() !== '' && Number.isInteger(node) && node >= 0 && node < count;
  parts.number.setAttribute('aria-invalid', String(!is_good));
  if (is_good) store.set('selection', {node});
  else show_error(`Nodes run from 0 to ${count - 1}.`);
}

function show_error(text) {
  set_text(parts.error, text);
  parts.error.hidden = !text;
}

let last_increment = null,
  is_loading = false;
function load_with_run() {
  const status = store.get('status'),
    increment = `${status.branch}.${status.increment}`;
  if (store.get('shown') !== 'live' || increment === last_increment || is_loading) return;
  last_increment = increment;
  load();
}

async function load() {
  if (store.get('tab') !== 'inspect') return;
  const selection = store.get('selection');
  show_error(selection?.error ? `Nothing was picked: ${selection.error}` : '');
  if (!selection || selection.missed || selection.error) return show_hint(selection);
  if (selection.nodes) return show_many(selection);
  const ticket = ++asked;
  is_loading = true;
  try {
    const values = await get(`/api/node/${selection.node}`, {state: state_name()});
    if (ticket === asked) show_node(values, selection);
  } catch (error) {
    if (ticket === asked) show_error(`Node ${selection.node}: ${error.message}`);
  }
  is_loading = false;
}

function show_hint(selection) {
  parts.node = null;
  replace(
    parts.body,
    el(
      'p',
      {class: 'hint'},
      selection?.missed
        ? 'There is no wall at that place.'
        : 'Click the wall to see its values. Drag with Ctrl or Alt for a rectangle of nodes. Without a mouse: Enter picks what is in the middle of the picture.'
    )
  );
}

function show_node(values, selection) {
  const is_new = parts.node !== values.node;
  parts.node = values.node;
  parts.values = values;
  parts.number.value = values.node;
  const table = el(
    'table',
    {class: 'values', id: 'node-values'},
    el(
      'caption',
      {},
      `Node ${values.node}`,
      el(
        'span',
        {class: 'moment'},
        `${selection.element !== undefined && selection.element !== null ? `element ${selection.element} · ` : ''}increment ${values.increment} · ${format(values.time_s)} s`
      )
    ),
    el(
      'tbody',
      {},
      kValues.filter(([key]) => key in values).map(([key, caption, unit]) => make_row(key, caption, unit, values))
    )
  );
  if (!is_new && parts.table?.isConnected) {
    parts.table.replaceWith(table);
    parts.table = table;
    return load_history();
  }
  parts.table = table;
  parts.history = el(
    'div',
    {id: 'node-history'},
    [...parts.charts.values()].map((chart) => chart.root)
  );
  replace(
    parts.body,
    table,
    el(
      'div',
      {class: 'row'},
      button({text: 'Fly there', title: 'Look at this node from near', id: 'fly'}, () => fly_to_node(parts.values)),
      store.get('status')?.can_steer
        ? button({text: 'Run until it lets go', title: 'Halts when this node lets go'}, () =>
            act(`until node ${values.node}`)
          )
        : null
    ),
    parts.history
  );
  load_history();
}

function make_row(key, caption, unit, values) {
  const value = values[key],
    is_list = Array.isArray(value),
    cell = el('td', {'data-key': key, colspan: is_list ? 2 : null});
  if (key === 'contact') {
    cell.append(el('span', {class: `class ${value}`}, value ?? '–'));
  } else if (is_list) {
    cell.append(value.map((one) => format(one, 4)).join('\u2002'));
    cell.className = 'list';
  } else {
    cell.append(typeof value === 'string' ? value : format(value, 5));
  }
  if (typeof value === 'number') cell.dataset.value = String(value);
  if (key === 'margin_N') cell.className = margin_class(values);
  const is_known = value !== null && value !== undefined;
  return el(
    'tr',
    {},
    el('th', {scope: 'row'}, is_list && unit ? `${caption} [${unit}]` : caption),
    cell,
    is_list ? null : el('td', {class: 'unit'}, is_known ? unit : '')
  );
}

/// Red below a twentieth of what holds it, amber below a fifth.
function margin_class(values) {
  if (values.margin_N === null || values.margin_N === undefined) return '';
  const scale = Math.max(Math.abs(values.normal_force_N ?? 0), Math.abs(values.release_threshold_N ?? 0), 1e-12);
  const share = values.margin_N / scale;
  return share < 0.05 ? 'near' : share < 0.2 ? 'close' : 'safe';
}

let history = null,
  history_key = '';
async function load_history() {
  if (store.get('tab') !== 'inspect' || parts.node === null || parts.node === undefined) return;
  const status = store.get('status'),
    key = `${parts.node}|${status?.branch}|${store.get('kept').length}`;
  if (key !== history_key) {
    try {
      history = await get(`/api/node/${parts.node}/history`);
      history_key = key;
    } catch (error) {
      return show_error(`No history: ${error.message}`);
    }
  }
  const marked = find_marked();
  for (const [name, , tint] of kHistories)
    parts.charts
      .get(name)
      .show(history[name] ? [{name, colour: tint, x: history.time_s, y: history[name]}] : [], marked);
}

/// fly(place, size): set by the page; here only the place is known.
let fly = () => {};
export function set_flight(action) {
  fly = action;
}
function fly_to_node(values) {
  if (values?.position_mm) fly(values.position_mm, 0, values.tool_normal);
}

function show_many(selection) {
  parts.node = null;
  const {summary} = selection,
    counts = summary.contact ?? {};
  const figures = Object.entries(summary).filter(([, value]) => value && typeof value === 'object' && 'min' in value);
  replace(
    parts.body,
    el('h3', {}, `${selection.nodes.length} nodes`),
    el(
      'p',
      {class: 'legend wide'},
      kClasses
        .filter((name) => counts[name] !== undefined)
        .map((name) => el('span', {}, el('span', {class: `class ${name}`}, name), ` ${counts[name]}`))
    ),
    el(
      'table',
      {class: 'values', id: 'many-values'},
      el(
        'thead',
        {},
        el(
          'tr',
          {},
          ['', 'least', 'mean', 'most'].map((text) => el('th', {scope: 'col'}, text))
        )
      ),
      el(
        'tbody',
        {},
        figures.map(([name, value]) =>
          el(
            'tr',
            {},
            el('th', {scope: 'row'}, name.replace(/_/g, ' ')),
            ['min', 'mean', 'max'].map((which) => el('td', {}, format(value[which])))
          )
        )
      )
    ),
    make_node_table(selection.nodes)
  );
}
