// SPDX-License-Identifier: GPL-3.0-or-later
// The journal of the run, what this page sent, and a line for commands in words.
import {get_text, viewer} from './api.js';
import {send} from './commands.js';
import {el, replace} from './dom.js';
import {read_journal} from './scene_values.js';
import {store} from './store.js';

const kForms = [
  'run',
  'pause',
  'step [N]',
  'until touch | slip | detachment | yield',
  'until pressure P | time T | thinning X | node N',
  'set KEY VALUE',
  'back INCREMENT',
  'stop'
];
const parts = {};
const typed = [];
let at = 0,
  is_loading = false;

export function build_log(root) {
  parts.journal = el('ol', {class: 'journal', id: 'journal', 'aria-label': 'Journal of the run'});
  parts.replies = el('ol', {
    class: 'replies',
    id: 'replies',
    'aria-live': 'polite',
    'aria-label': 'Sent from this page'
  });
  parts.line = el('input', {
    type: 'text',
    id: 'console',
    'aria-label': 'Command',
    placeholder: 'command, e.g. until pressure 20',
    autocomplete: 'off',
    spellcheck: 'false',
    list: 'console-words'
  });
  const words = el(
    'datalist',
    {id: 'console-words'},
    [
      'run',
      'pause',
      'step',
      'until touch',
      'until slip',
      'until detachment',
      'until yield',
      'until pressure ',
      'until time ',
      'set ',
      'back ',
      'stop'
    ].map((value) => el('option', {value}))
  );
  const form = el(
    'form',
    {class: 'row console', onsubmit: enter},
    el('label', {for: 'console', class: 'prompt'}, '›'),
    parts.line,
    words,
    el('button', {type: 'submit'}, 'Send')
  );
  parts.line.addEventListener('keydown', recall);
  replace(
    root,
    el(
      'details',
      {},
      el('summary', {}, 'Commands'),
      el(
        'ul',
        {class: 'forms'},
        kForms.map((text) => el('li', {}, el('code', {}, text)))
      )
    ),
    el('h3', {}, 'Sent from this page'),
    parts.replies,
    form,
    el('h3', {}, 'Journal'),
    parts.journal
  );
  store.on('log', () => {
    draw_replies();
    load();
  });
  store.on(['tab', 'kept'], load);
  draw_replies();
}

export function focus_console() {
  store.set('tab', 'log');
  parts.line.focus();
}

async function enter(event) {
  event.preventDefault();
  const text = parts.line.value.trim();
  if (!text) return;
  typed.push(text);
  at = typed.length;
  parts.line.value = '';
  await send(text);
  parts.line.focus();
}

function recall(event) {
  const by = {ArrowUp: -1, ArrowDown: 1}[event.key];
  if (event.key === 'Escape') parts.line.blur();
  if (!by || !typed.length) return;
  event.preventDefault();
  at = Math.min(typed.length, Math.max(0, at + by));
  parts.line.value = typed[at] ?? '';
}

function draw_replies() {
  const log = store.get('log');
  replace(
    parts.replies,
    log.length
      ? log
          .slice(-60)
          .map((one) =>
            el(
              'li',
              {class: one.ok ? 'good' : 'error'},
              el('code', {}, one.command),
              el('span', {class: 'faint'}, ` increment ${one.increment ?? '–'}`),
              el('p', {}, one.text)
            )
          )
      : el('li', {class: 'hint'}, 'Nothing yet.')
  );
  parts.replies.scrollTop = parts.replies.scrollHeight;
}

/// journal.jsonl of the present branch, newest first.
async function load() {
  if (store.get('tab') !== 'log' || is_loading) return;
  is_loading = true;
  try {
    const lines = read_journal(await get_text('/api/file', {name: 'journal.jsonl'}));
    replace(parts.journal, lines.reverse().slice(0, 300).map(make_entry));
  } catch (error) {
    replace(
      parts.journal,
      el('li', {class: 'hint'}, error.status === 404 ? 'No journal yet.' : `No journal: ${error.message}`)
    );
  }
  is_loading = false;
}

function make_entry(line) {
  const {increment, branch, command, end, message, who, time_s, at, started, version} = line;
  if (line.journal)
    return el(
      'li',
      {},
      el('span', {class: 'number'}),
      `begun by version ${version}`,
      el('span', {class: 'faint'}, ` ${(started ?? '').replace('T', ' ').replace(/:\d\dZ$/, '')}`)
    );
  const person = who === viewer ? 'you' : /^v[0-9a-f]{16}$/.test(who ?? '') ? 'another viewer' : (who ?? '');
  return el(
    'li',
    {title: `${branch ? `branch ${branch}, ` : ''}${time_s ?? ''} s, ${at ?? ''}`},
    el('span', {class: 'number'}, String(increment ?? '')),
    command ? el('code', {}, command) : `ended: ${end}${message ? `, ${message}` : ''}`,
    el('span', {class: 'faint'}, ` ${person}`)
  );
}
