// SPDX-License-Identifier: GPL-3.0-or-later
// A table that is sorted by its headings and walked through with arrow keys; Enter or a click chooses a row.
import {el} from './dom.js';

/// columns: [{key, caption, title, format(value, row), kind}]; sort: {key, is_down}, kept by the caller when it is given.
export function sort_table({id, columns, rows, choose, sort = {key: null, is_down: false}, caption = null}) {
  const body = el('tbody', {});
  const table = el(
    'table',
    {class: 'sorted', id},
    caption ? el('caption', {}, caption) : null,
    el('thead', {}, el('tr', {}, columns.map(make_heading))),
    body
  );
  fill();

  function make_heading(column) {
    const node = el(
      'th',
      {scope: 'col', title: column.title},
      el('button', {type: 'button', onclick: () => order(column.key)}, column.caption)
    );
    node.dataset.key = column.key;
    return node;
  }

  function order(key) {
    sort.is_down = sort.key === key ? !sort.is_down : false;
    sort.key = key;
    fill();
  }

  function fill() {
    for (const heading of table.querySelectorAll('thead th'))
      heading.setAttribute(
        'aria-sort',
        heading.dataset.key !== sort.key ? 'none' : sort.is_down ? 'descending' : 'ascending'
      );
    const sorted =
      sort.key === null ? rows : [...rows].sort((a, b) => compare(a[sort.key], b[sort.key]) * (sort.is_down ? -1 : 1));
    body.replaceChildren(...sorted.map((row, i) => make_row(row, i === 0)));
  }

  function make_row(row, is_first) {
    const node = el(
      'tr',
      {
        tabindex: is_first ? '0' : '-1',
        'data-keys': true,
        class: row.class,
        onclick: () => choose_row(node, row),
        onkeydown: (event) => walk(event, node, row)
      },
      columns.map((column) =>
        el(
          'td',
          {class: column.kind?.(row)},
          column.format ? column.format(row[column.key], row) : String(row[column.key] ?? '–')
        )
      )
    );
    return node;
  }

  function choose_row(node, row) {
    for (const other of body.children) other.classList.toggle('chosen', other === node);
    focus(node);
    choose(row);
  }

  function walk(event, node, row) {
    const next = {
      ArrowDown: node.nextElementSibling,
      ArrowUp: node.previousElementSibling,
      Home: body.firstElementChild,
      End: body.lastElementChild
    }[event.key];
    if (event.key === 'Enter' || event.key === ' ') choose_row(node, row);
    else if (next) focus(next);
    else if (!['ArrowDown', 'ArrowUp'].includes(event.key)) return;
    event.preventDefault();
  }

  function focus(node) {
    for (const other of body.children) other.tabIndex = other === node ? 0 : -1;
    node.focus();
  }
  return table;
}

/// Numbers before words, unknown values last.
function compare(a, b) {
  const unknown = (value) => value === null || value === undefined || Number.isNaN(value);
  if (unknown(a) || unknown(b)) return Number(unknown(a)) - Number(unknown(b));
  if (typeof a === 'number' && typeof b === 'number') return a - b;
  return String(a).localeCompare(String(b), undefined, {numeric: true});
}
