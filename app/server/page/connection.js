// SPDX-License-Identifier: GPL-3.0-or-later
// The event stream: kept open, opened again after a loss, given up when the token is refused.
import {get, url, watch_answers} from './api.js';
import {store} from './store.js';

const kWaits = [500, 1000, 2000, 3000, 5000]; // [ms] before each new attempt
const kSilence = 15000; // [ms] after which the program is asked whether it is there

let source = null,
  attempt = 0,
  timer = null,
  last_sign = 0;
const handlers = {warning: () => {}, contact: () => {}, recovered: () => {}};

/// handlers: warning(data), contact(data), recovered() after a loss.
export function connect(given) {
  Object.assign(handlers, given);
  watch_answers(hear_answer);
  setInterval(watch_silence, 5000);
  open_stream();
}

export function retry_now() {
  clearTimeout(timer);
  probe();
}

export function next_attempt() {
  return attempt;
}

function hear_answer(status) {
  if (status === 401) refuse();
  else if (status === 0) lose();
  else last_sign = Date.now();
}

function open_stream() {
  source?.close();
  source = new EventSource(url('/api/events'));
  source.addEventListener('open', on_open);
  source.addEventListener('error', lose);
  source.addEventListener('status', (event) => {
    on_sign();
    store.set('status', JSON.parse(event.data));
  });
  for (const name of ['warning', 'contact'])
    source.addEventListener(name, (event) => {
      on_sign();
      handlers[name](JSON.parse(event.data));
    });
}

function on_sign() {
  last_sign = Date.now();
}

function on_open() {
  on_sign();
  const was_lost = store.get('connection') === 'lost';
  attempt = 0;
  store.set('connection', 'open');
  if (was_lost) handlers.recovered();
}

function lose() {
  if (store.get('connection') === 'refused' || timer) return;
  source?.close();
  store.set('connection', 'lost');
  timer = setTimeout(probe, kWaits[Math.min(attempt, kWaits.length - 1)]);
  attempt += 1;
}

/// An event stream does not tell why it failed; a plain request does.
async function probe() {
  timer = null;
  try {
    await get('/api/status');
    open_stream();
  } catch {
    // hear_answer() has seen to it.
  }
}

function refuse() {
  clearTimeout(timer);
  source?.close();
  store.set('connection', 'refused');
}

function watch_silence() {
  if (store.get('connection') !== 'open' || Date.now() - last_sign < kSilence) return;
  on_sign();
  get('/api/status').catch(() => {});
}
