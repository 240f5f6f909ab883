// SPDX-License-Identifier: GPL-3.0-or-later
// Change what is ahead: a field for each key that may be set, each with its own answer.
import {may_steer, send} from './commands.js';
import {el, replace, set_text} from './dom.js';
import {read_scene_values} from './scene_values.js';
import {store} from './store.js';

const parts = {rows: []};

export function build_change(root) {
  parts.filter = el('input', {
    type: 'search',
    id: 'change-filter',
    'aria-label': 'Find a key',
    placeholder: 'find a key',
    autocomplete: 'off',
    oninput: filter
  });
  parts.list = el('div', {id: 'change-list'});
  parts.why = el('p', {class: 'hint', hidden: true});
  replace(
    root,
    el(
      'p',
      {class: 'faint'},
      'Values are written as in the scene and checked as strictly. A change holds from the next increment on and stands in the journal.'
    ),
    parts.why,
    parts.filter,
    parts.list
  );
  store.on('model', draw);
  store.on(['status', 'connection'], update);
  store.on(['tab', 'log'], show_values);
}

function draw() {
  const keys = (store.get('model')?.settable ?? []).map((one) => (typeof one === 'string' ? {key: one} : one));
  const groups = new Map();
  for (const one of keys) {
    const group = one.key.includes('.') ? one.key.slice(0, one.key.lastIndexOf('.')) : '';
    groups.set(group, [...(groups.get(group) ?? []), one]);
  }
  parts.rows = [];
  replace(
    parts.list,
    [...groups].map(([group, list]) => el('fieldset', {}, el('legend', {}, group), list.map(make_row)))
  );
  update();
}

function make_row(one) {
  const id = `set-${one.key.replace(/[^\w]/g, '-')}`,
    name = one.key.slice(one.key.lastIndexOf('.') + 1);
  const field = el('input', {
    type: 'text',
    id,
    autocomplete: 'off',
    spellcheck: 'false',
    'aria-describedby': `${id}-note`,
    placeholder: 'default',
    title: one.doc ?? one.key
  });
  const submit = el('button', {type: 'submit', class: 'small', 'aria-label': `Set ${one.key}`}, 'Set');
  const note = el('p', {id: `${id}-note`, class: 'note', role: 'status'});
  const row = el(
    'form',
    {class: 'set', 'data-key': one.key},
    el('label', {for: id, title: one.doc ?? one.key}, name),
    field,
    submit,
    note
  );
  row.addEventListener('submit', async (event) => {
    event.preventDefault();
    if (field.value.trim() === '') return show(false, 'a value is missing');
    const reply = await send(`set ${one.key} ${field.value.trim()}`);
    show(reply.ok, reply.text);
  });
  const show = (ok, text) => {
    set_text(note, text);
    note.className = `note ${ok ? 'good' : 'error'}`;
    field.setAttribute('aria-invalid', String(!ok));
  };
  parts.rows.push({key: one.key, row, field, submit});
  return row;
}

/// What holds now stands in the empty fields, grey.
async function show_values() {
  if (store.get('tab') !== 'change') return;
  const values = await read_scene_values();
  for (const {key, field} of parts.rows) {
    field.placeholder = values.get(key) ?? 'default';
    field.title = `${key} = ${field.placeholder}`;
  }
}

function filter() {
  const words = parts.filter.value.toLowerCase().split(/\s+/).filter(Boolean);
  for (const {key, row} of parts.rows) row.hidden = !words.every((word) => key.toLowerCase().includes(word));
  for (const group of parts.list.children)
    group.hidden = [...group.querySelectorAll('form')].every((row) => row.hidden);
}

function update() {
  const status = store.get('status'),
    can = may_steer() && status.phase !== 'ended';
  for (const {submit} of parts.rows) submit.disabled = !can;
  parts.why.hidden = can;
  if (!can)
    set_text(
      parts.why,
      !status?.can_steer
        ? 'A finished run cannot be changed.'
        : status.phase === 'ended'
          ? 'The run has ended. Go back to a kept state to change what follows it.'
          : 'Another viewer steers. Take the wheel to change something.'
    );
}
