// SPDX-License-Identifier: GPL-3.0-or-later
// From places on a picture to nodes.
import {get} from './api.js';
import {store} from './store.js';

/// Place on the page [px] to the node nearest to what is seen there.
export async function pick_point(viewport, x, y) {
  Object.assign(viewport.pin.style, {left: `${x}px`, top: `${y}px`});
  viewport.pin.hidden = false;
  const params = viewport.picked_params(),
    scale = params.w / viewport.surface.clientWidth;
  try {
    const found = await get('/api/pick', {...params, x: x * scale, y: y * scale});
    store.set(
      'selection',
      found.node === null || found.node === undefined ? {missed: true} : {node: found.node, element: found.element}
    );
  } catch (error) {
    store.set('selection', {error: error.message});
  }
  store.set('tab', 'inspect');
  if (store.get('selection').node === undefined) viewport.pin.hidden = true;
}

/// The band while it is drawn (`is_done` false), its nodes at the end, nothing when it was broken off (null).
export async function pick_rectangle(viewport, x0, y0, x1, y1, is_done) {
  const [left, right] = [Math.min(x0, x1), Math.max(x0, x1)],
    [top, bottom] = [Math.min(y0, y1), Math.max(y0, y1)];
  viewport.band.hidden = is_done !== false;
  Object.assign(viewport.band.style, {
    left: `${left}px`,
    top: `${top}px`,
    width: `${right - left}px`,
    height: `${bottom - top}px`
  });
  if (!is_done) return;
  const params = viewport.picked_params(),
    scale = params.w / viewport.surface.clientWidth;
  try {
    const found = await get('/api/pick_box', {
      ...params,
      x0: left * scale,
      y0: top * scale,
      x1: right * scale,
      y1: bottom * scale
    });
    store.set('selection', found.nodes.length ? found : {missed: true});
  } catch (error) {
    store.set('selection', {error: error.message});
  }
  store.set('tab', 'inspect');
}
