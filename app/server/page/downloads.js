// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and films as files.
import {url} from './api.js';
import {button, el, set_text} from './dom.js';
import {store} from './store.js';

const kPictureWidth = 1920;

function save(address, name) {
  const link = el('a', {href: address, download: name});
  document.body.append(link);
  link.click();
  link.remove();
}

/// Same camera and shape as on the page, `width` pixels wide.
function full_size(viewport, width) {
  const {w, h, q, after, marked, ...params} = viewport.params('rest');
  const even = (value) => 2 * Math.round(value / 2);
  return {...params, marked, w: width, h: Math.max(64, even((width * h) / w)), smooth: 2};
}

export function download_picture(viewport) {
  const params = {...full_size(viewport, kPictureWidth), slot: 'download', format: 'png', download: 1};
  const {increment} = viewport.surface.dataset;
  save(url('/api/frame', params), `${params.view}-${increment ?? 0}.png`);
}

/// The program draws it between live pictures; progress is shown until it can be fetched.
export async function download_film(viewport) {
  const bar = el('progress', {'aria-label': 'Film'}),
    line = el('p', {role: 'status'}, 'Drawing kept states…');
  const dialog = el('dialog', {class: 'ask', 'aria-label': 'Film'}, el('h2', {}, 'Film of the kept states'), line, bar);
  const stopper = new AbortController();
  dialog.append(
    el(
      'div',
      {class: 'row end'},
      button({text: 'Cancel', title: 'Do not make it'}, () => dialog.close())
    )
  );
  dialog.addEventListener('close', () => {
    stopper.abort();
    dialog.remove();
  });
  document.body.append(dialog);
  dialog.showModal();
  const {slot, state, ...params} = full_size(viewport, 960);
  const address = url('/api/animation', {...params, format: 'webp'});
  try {
    if (await wait_for_film(address, stopper.signal, bar, line)) {
      save(address, `${params.view}.webp`);
      dialog.close();
    }
  } catch (error) {
    if (error.name !== 'AbortError') set_text(line, `No film: ${error.message}`);
  }
}

/// Asks until the answer is no longer 202 {done, of}.
async function wait_for_film(address, signal, bar, line) {
  while (store.get('connection') === 'open') {
    const answer = await fetch(address, {signal, cache: 'no-store'});
    if (answer.status !== 202) {
      if (answer.ok) {
        await answer.body?.cancel();
        return true;
      }
      throw new Error((await answer.json().catch(() => ({}))).error ?? `the program answered ${answer.status}`);
    }
    const {done, of} = await answer.json();
    Object.assign(bar, {max: of || 1, value: done || 0});
    set_text(line, `Drawn: ${done} of ${of} kept states`);
    await new Promise((resolve) => setTimeout(resolve, 400));
  }
  throw new Error('the connection was lost');
}
