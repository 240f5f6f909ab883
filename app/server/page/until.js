// SPDX-License-Identifier: GPL-3.0-or-later
// "Run until": a small form under a button.
import {button, el, set_text} from './dom.js';
import {store} from './store.js';

const kHalts = [
  {name: 'touch', caption: 'the next node touches a tool'},
  {name: 'slip', caption: 'the next node begins to slip'},
  {name: 'detachment', caption: 'the next node lets go'},
  {name: 'yield', caption: 'the first plastic strain'},
  {name: 'pressure', caption: 'the pressure is', unit: 'MPa'},
  {name: 'time', caption: 'the time is', unit: 's'},
  {name: 'thinning', caption: 'the wall has thinned by', unit: '(0.2 = 20 %)'},
  {name: 'node', caption: 'this node lets go', unit: 'node number'},
  {name: 'step', caption: 'so many increments are done', unit: 'increments'}
];

/// act(text) sends; -> {root, set_disabled}.
export function make_until(act) {
  const select = el(
    'select',
    {id: 'until-kind', 'aria-label': 'Run until'},
    kHalts.map((halt) => el('option', {value: halt.name}, halt.caption))
  );
  const value = el('input', {
    type: 'text',
    inputmode: 'decimal',
    id: 'until-value',
    'aria-label': 'Value',
    autocomplete: 'off',
    'aria-describedby': 'until-error'
  });
  const unit = el('span', {class: 'unit'});
  const error = el('p', {class: 'error', id: 'until-error', role: 'alert', hidden: true});
  const form = el(
    'form',
    {class: 'popover', id: 'until-form', hidden: true, 'aria-label': 'Run until'},
    el('label', {}, 'Run until', select),
    el('div', {class: 'row'}, value, unit),
    error,
    el(
      'div',
      {class: 'row end'},
      button({text: 'Close', title: 'Close'}, close),
      el('button', {type: 'submit', class: 'primary', id: 'until-go'}, 'Run')
    )
  );
  const opener = button(
    {icon: 'until', text: 'Until…', title: 'Run until something happens', key: 'U', id: 'until'},
    () => (form.hidden ? open() : close())
  );
  opener.setAttribute('aria-expanded', 'false');
  opener.setAttribute('aria-controls', 'until-form');
  const root = el('div', {class: 'anchor'}, opener, form);

  const find_halt = () => kHalts.find((halt) => halt.name === select.value);

  function update() {
    const halt = find_halt();
    value.parentElement.hidden = !halt.unit;
    set_text(unit, halt.unit ?? '');
    const selection = store.get('selection');
    value.value = halt.name === 'node' && selection?.node !== undefined ? selection.node : '';
    show_error('');
  }

  function show_error(text) {
    error.hidden = !text;
    set_text(error, text);
    value.setAttribute('aria-invalid', String(Boolean(text)));
  }

  function open() {
    form.hidden = false;
    opener.setAttribute('aria-expanded', 'true');
    update();
    select.focus();
  }

  function close() {
    if (form.contains(document.activeElement)) opener.focus();
    form.hidden = true;
    opener.setAttribute('aria-expanded', 'false');
  }

  select.addEventListener('change', () => {
    update();
    if (find_halt().unit) value.focus();
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') {
      event.stopPropagation();
      close();
    }
  });
  document.addEventListener('pointerdown', (event) => {
    if (!form.hidden && !root.contains(event.target)) close();
  });
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    const halt = find_halt();
    if (halt.unit && value.value.trim() === '') return show_error('a number is missing');
    store.set('shown', 'live');
    const words = [halt.name, halt.unit ? value.value.trim() : ''].filter(Boolean).join(' ');
    const reply = await act(halt.name === 'step' ? words : `until ${words}`);
    if (reply.ok) close();
    else show_error(reply.text);
  });
  return {
    root,
    set_disabled: (is_disabled) => {
      opener.disabled = is_disabled;
      if (is_disabled) close();
    }
  };
}
