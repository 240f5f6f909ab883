// SPDX-License-Identifier: GPL-3.0-or-later
// The run as it goes: pressure, contact, residual, thinnest wall, the scene's quantities, what limited each increment.
import {el, replace, set_text} from './dom.js';
import {format} from './numbers.js';
import {line, LineChart, nearest, start_canvas} from './line_chart.js';
import {store} from './store.js';
import {colour} from './theme.js';

const kLimiters = [
  'path',
  'strain',
  'rotation',
  'thickness',
  'yield',
  'touch',
  'release',
  'stick-to-slip',
  'slide',
  'convergence',
  'quantity',
  'error',
  'none'
];
const kLeft = 52,
  kRight = 10;
let charts = null,
  strip = null,
  extra = null;
const quantity_charts = new Map();

/// pick(time): shows the kept state nearest to it.
export function build_charts(root, pick) {
  const make = (title, options = {}) => new LineChart({title, pick, ...options});
  charts = {
    pressure: make('Pressure [MPa]'),
    contact: make('Nodes in contact', {is_step: true}),
    residual: make('Out-of-balance force [-]', {is_log: true}),
    thickness: make('Thinnest wall [mm]')
  };
  strip = make_strip();
  extra = el('div', {});
  replace(
    root,
    charts.pressure.root,
    strip.root,
    charts.contact.root,
    charts.residual.root,
    charts.thickness.root,
    extra
  );
  store.on(['rows', 'shown', 'theme', 'tab', 'kept'], draw);
}

const column = (rows, name) => rows.map((row) => row[name]);

function draw() {
  if (store.get('tab') !== 'charts') return;
  const rows = store.get('rows'),
    x = column(rows, 'time_s'),
    marked = find_marked();
  const one = (name, tint = 'line-1') => [{name, colour: tint, x, y: column(rows, name)}];
  charts.pressure.show(one('pressure_MPa'), marked);
  charts.contact.show(
    [
      {name: 'contact', colour: 'line-1', x, y: column(rows, 'n_contact')},
      {name: 'slip', colour: 'line-3', x, y: column(rows, 'n_slip')},
      {name: 'stick', colour: 'line-2', x, y: column(rows, 'n_stick')}
    ],
    marked
  );
  charts.residual.show(one('residual'), marked);
  charts.thickness.show(one('thickness_min_mm'), marked);
  strip.show(rows, marked);
  draw_quantities(rows, x, marked);
}

function draw_quantities(rows, x, marked) {
  const names = Object.keys(rows.at(-1)?.quantities ?? {});
  if (names.join() !== [...quantity_charts.keys()].join()) {
    quantity_charts.clear();
    for (const name of names) quantity_charts.set(name, new LineChart({title: name, pick: charts.pressure.pick}));
    replace(
      extra,
      [...quantity_charts.values()].map((chart) => chart.root)
    );
  }
  for (const [name, chart] of quantity_charts)
    chart.show([{name, colour: 'line-4', x, y: rows.map((row) => row.quantities?.[name] ?? null)}], marked);
}

/// Time of the kept state that is looked at; null for the newest one.
export function find_marked() {
  const shown = store.get('shown');
  if (shown === 'live') return null;
  return (
    store.get('kept').find((state) => state.branch === shown.branch && state.increment === shown.increment)?.time_s ??
    null
  );
}

/// A strip coloured by what limited each increment, and how often each did.
function make_strip() {
  const canvas = el('canvas', {class: 'chart-canvas strip', role: 'img', 'aria-label': 'What limited each increment'});
  const readout = el('output', {class: 'value'}),
    legend = el('div', {class: 'legend wide'});
  const root = el(
    'figure',
    {class: 'chart'},
    el('figcaption', {}, el('span', {}, 'Limiter of each increment'), readout),
    canvas,
    legend
  );
  let rows = [],
    marked = null;

  const tint = (name) => colour(`limit-${Math.max(0, kLimiters.indexOf(name)) + 1}`);

  function draw_strip() {
    const context = start_canvas(canvas);
    if (!context || !rows.length) return;
    const last = rows.at(-1).time_s || 1,
      first = Math.min(0, rows[0].time_s);
    const to_x = (time) => kLeft + ((canvas.clientWidth - kLeft - kRight) * (time - first)) / (last - first);
    let before = first;
    for (const row of rows) {
      context.fillStyle = tint(row.limited_by);
      context.fillRect(to_x(before), 2, Math.max(0.5, to_x(row.time_s) - to_x(before) + 0.5), canvas.clientHeight - 4);
      before = row.time_s;
    }
    if (marked === null) return;
    context.strokeStyle = colour('text');
    line(context, to_x(marked), 0, to_x(marked), canvas.clientHeight);
  }

  canvas.addEventListener('pointermove', (event) => {
    if (!rows.length) return;
    const last = rows.at(-1).time_s || 1,
      first = Math.min(0, rows[0].time_s),
      box = canvas.getBoundingClientRect();
    const time = first + ((event.clientX - box.left - kLeft) / (box.width - kLeft - kRight)) * (last - first);
    const row =
      rows[
        nearest(
          rows.map((one) => one.time_s),
          time
        )
      ];
    set_text(
      readout,
      `${row.increment}: ${row.limited_by}${row.limited_at >= 0 ? ` at ${row.limited_at}` : ''}, ${format(100 * row.step_fraction, 3)} % of the step`
    );
  });
  canvas.addEventListener('pointerleave', () => set_text(readout, ''));
  new ResizeObserver(draw_strip).observe(canvas);

  function show(new_rows, new_marked) {
    [rows, marked] = [new_rows, new_marked];
    const counts = new Map();
    for (const row of rows) counts.set(row.limited_by, (counts.get(row.limited_by) ?? 0) + 1);
    replace(
      legend,
      [...counts]
        .sort((a, b) => b[1] - a[1])
        .map(([name, count]) => {
          const swatch = el('i', {class: 'swatch'});
          swatch.style.background = tint(name);
          return el('span', {}, swatch, `${name} ${count}`);
        })
    );
    draw_strip();
  }
  return {root, show};
}
