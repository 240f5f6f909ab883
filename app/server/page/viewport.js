// SPDX-License-Identifier: GPL-3.0-or-later
// One picture with its heading: which view, which range of colours, what is under the pointer.
import {get_frame} from './api.js';
import {camera_params, kHome, orbit, pan, zoom_at} from './camera.js';
import {button, el, set_text} from './dom.js';
import {download_film, download_picture} from './downloads.js';
import {FrameLoop} from './frame_loop.js';
import {attach_gestures} from './gestures.js';
import {format} from './numbers.js';
import {pick_point, pick_rectangle} from './picking.js';
import {state_name, store} from './store.js';

const kDragWidth = 640,
  kMostWidth = 2560,
  kMostHeight = 1600;
const kMostMarks = 12; // more rings hide what they mark
const kWithoutRange = ['contact-map', 'tool-normals', 'chatter'];
export const view_title = (name) => name.replace(/-/g, ' ').replace(/^./, (c) => c.toUpperCase());

export class Viewport {
  #range = null; // of the colours of the last picture
  #bitmap = null;

  constructor(slot) {
    this.slot = slot;
    this.#build();
    this.loop = new FrameLoop({
      fetch: (kind, after, signal) => get_frame(this.params(kind, after), signal),
      draw: (frame, kind) => this.#draw(frame, kind),
      fail: (error) => this.#show_error(error),
      live: find_live,
      is_ready: () =>
        this.is_visible() && store.get('connection') === 'open' && store.get('model') !== null && !document.hidden
    });
    attach_gestures(this.surface, this.#gestures());
    store.on(['display', 'theme', 'slots', 'selection'], () => this.loop.change());
    store.on('camera', () => this.loop.change(true));
    store.on('shown', () => this.loop.change(store.get('scrubbing') === true));
    store.on(['status', 'connection', 'model', 'two_views'], () => this.loop.pump());
    store.on('slots', () => this.#update_heading());
    store.on('active', (active) => this.root.classList.toggle('active', active === slot));
    document.addEventListener('visibilitychange', () => this.loop.pump());
    new ResizeObserver(() => {
      this.#fit_canvas();
      this.loop.change(true);
    }).observe(this.surface);
  }

  is_visible() {
    return this.slot === 'a' || store.get('two_views');
  }

  #build() {
    const slot = this.slot;
    this.select = el('select', {
      'aria-label': `View of picture ${slot.toUpperCase()}`,
      class: 'view',
      onchange: () => this.#set({view: this.select.value, range: null})
    });
    this.low = this.#make_bound('Lower end of the colours');
    this.high = this.#make_bound('Upper end of the colours');
    this.lock = button({icon: 'lock', title: 'Keep this range of colours', pressed: false, kind: 'small'}, () =>
      this.#toggle_lock()
    );
    this.range = el(
      'span',
      {class: 'range', role: 'group', 'aria-label': 'Range of the colours'},
      this.low,
      '…',
      this.high,
      this.lock
    );
    this.moment = el('span', {class: 'moment'});
    this.pace = el('span', {class: 'pace', title: 'time that drawing the last picture took'});
    this.canvas = el('canvas', {'aria-hidden': 'true'});
    this.band = el('div', {class: 'band', hidden: true});
    this.pin = el('div', {class: 'pin', hidden: true});
    this.problem = el('div', {class: 'problem', role: 'alert', hidden: true});
    this.surface = el(
      'div',
      {class: 'surface', tabindex: '0', role: 'img', id: `surface-${slot}`, onfocus: () => store.set('active', slot)},
      this.canvas,
      this.band,
      this.pin,
      this.problem
    );
    this.root = el(
      'section',
      {class: `viewport${slot === 'a' ? ' active' : ''}`, 'aria-label': `Picture ${slot.toUpperCase()}`},
      el(
        'header',
        {},
        this.select,
        this.range,
        el('span', {class: 'grow'}),
        this.moment,
        this.pace,
        button(
          {
            icon: 'download',
            text: 'PNG',
            title: 'Download this picture in full size',
            kind: 'small',
            id: `png-${slot}`
          },
          () => download_picture(this)
        ),
        button(
          {
            icon: 'download',
            text: 'Film',
            title: 'Download all kept states as a film',
            kind: 'small',
            id: `film-${slot}`
          },
          () => download_film(this)
        )
      ),
      this.surface
    );
    this.root.addEventListener('pointerdown', () => store.set('active', slot));
  }

  #make_bound(label) {
    return el('input', {
      type: 'text',
      inputmode: 'decimal',
      class: 'bound',
      'aria-label': label,
      onchange: () => this.#enter_range()
    });
  }

  #set(fields) {
    store.patch('slots', {[this.slot]: {...this.#choice(), ...fields}});
  }
  #choice() {
    return store.get('slots')[this.slot];
  }

  #toggle_lock() {
    this.#set({range: this.#choice().range ? null : this.#range});
  }

  #enter_range() {
    const bounds = [this.low, this.high].map((field) => Number(field.value.replace('−', '-').replace(',', '.')));
    const is_good =
      bounds.every(Number.isFinite) && bounds[0] < bounds[1] && this.low.value !== '' && this.high.value !== '';
    for (const field of [this.low, this.high]) {
      field.setAttribute('aria-invalid', String(!is_good));
      field.title = is_good ? '' : 'two numbers, the lower one first';
    }
    if (is_good) this.#set({range: bounds});
  }

  #update_heading() {
    const choice = this.#choice(),
      model = store.get('model');
    if (!choice || !model) return;
    if (this.select.options.length !== model.views.length)
      this.select.replaceChildren(...model.views.map((name) => el('option', {value: name}, view_title(name))));
    this.select.value = choice.view;
    this.range.hidden = kWithoutRange.includes(choice.view);
    this.lock.setAttribute('aria-pressed', String(Boolean(choice.range)));
    const range = choice.range ?? this.#range;
    if (range && !this.range.contains(document.activeElement)) {
      this.low.value = format(range[0]);
      this.high.value = format(range[1]);
    }
  }

  /// Query of what is seen, for picking: the state that was drawn last, though the solver may be ahead of it.
  picked_params() {
    const {branch, increment} = this.surface.dataset;
    const params = this.params('rest');
    return increment === undefined ? params : {...params, state: `${branch}.${increment}`};
  }

  /// Query of this picture, as drawn (`rest`) or smaller while something moves.
  params(kind, after = null) {
    const {slot} = this,
      choice = this.#choice(),
      display = store.get('display'),
      selection = store.get('selection');
    const nodes = selection?.nodes ?? [];
    const marked = selection?.node !== undefined ? [selection.node] : nodes.length <= kMostMarks ? nodes : [];
    return {
      slot,
      state: state_name(),
      after,
      view: choice.view,
      ...this.#size(kind),
      ...camera_params(store.get('camera')),
      clip: display.clip,
      share: display.clip ? display.share : null,
      flip: display.clip && display.flip ? 1 : null,
      opacity: display.opacity,
      mirror: Number(display.mirror),
      edges: Number(display.edges),
      features: Number(display.features),
      density: display.density,
      scale: display.scale,
      lo: choice.range?.[0],
      hi: choice.range?.[1],
      theme: store.get('theme'),
      marked: marked.join(',')
    };
  }

  #size(kind) {
    const width = Math.max(64, this.surface.clientWidth),
      height = Math.max(64, this.surface.clientHeight);
    const dpr = window.devicePixelRatio || 1;
    const scale =
      kind === 'drag'
        ? Math.min(1, kDragWidth / width)
        : Math.min(kind === 'rest' ? dpr : 1, kMostWidth / width, kMostHeight / height);
    return {
      w: Math.max(64, Math.round(width * scale)),
      h: Math.max(64, Math.round(height * scale)),
      smooth: kind === 'rest' ? 2 : 1,
      q: {drag: 70, live: 82, rest: 92}[kind]
    };
  }

  #fit_canvas() {
    const dpr = Math.min(window.devicePixelRatio || 1, 2);
    this.canvas.width = Math.round(this.surface.clientWidth * dpr);
    this.canvas.height = Math.round(this.surface.clientHeight * dpr);
    if (this.#bitmap) this.#paint();
  }

  #paint() {
    const context = this.canvas.getContext('2d', {alpha: false});
    context.imageSmoothingQuality = 'high';
    context.drawImage(this.#bitmap, 0, 0, this.canvas.width, this.canvas.height);
  }

  #draw(frame, kind) {
    this.#bitmap?.close();
    this.#bitmap = frame.bitmap;
    this.#paint();
    this.problem.hidden = true;
    this.pin.hidden = true;
    this.#range = frame.range;
    Object.assign(this.surface.dataset, {
      kind,
      increment: frame.increment,
      branch: frame.branch,
      frames: Number(this.surface.dataset.frames || 0) + 1
    });
    const state = store.get('shown') === 'live' ? 'newest state' : 'kept state';
    set_text(this.moment, `${frame.branch ? `branch ${frame.branch}, ` : ''}increment ${frame.increment}`);
    set_text(this.pace, `${Math.round(frame.draw_ms)} ms`);
    this.surface.setAttribute(
      'aria-label',
      `${view_title(this.#choice().view)}, ${state}: increment ${frame.increment}, ` +
        `${format(frame.time)} s, ${format(frame.pressure)} MPa. Arrow keys turn, plus and minus zoom, Enter picks the middle.`
    );
    this.#update_heading();
  }

  #show_error(error) {
    if (error.status === 0 || error.status === 401) return; // told by the banner
    this.problem.hidden = false;
    set_text(this.problem, `No picture: ${error.message}`);
  }

  #gestures() {
    const change = (make) => store.set('camera', make(store.get('camera')));
    return {
      start: () => store.set('active', this.slot),
      orbit: (dx, dy) => change((camera) => orbit(camera, dx, dy)),
      pan: (dx, dy) => change((camera) => pan(camera, dx, dy, this.surface.clientHeight)),
      zoom: (factor, x, y) => change((camera) => this.#zoom(camera, factor, x, y)),
      click: (x, y) => pick_point(this, x, y),
      box: (x0, y0, x1, y1, is_done) => pick_rectangle(this, x0, y0, x1, y1, is_done),
      home: () => change((camera) => ({...camera, zoom: kHome.zoom, px: 0, py: 0, focus: null}))
    };
  }

  #zoom(camera, factor, x, y) {
    const width = this.surface.clientWidth,
      height = this.surface.clientHeight;
    return zoom_at(camera, factor, (x - width / 2) / height, (height / 2 - y) / height);
  }
}

/// Where the newest state is, when that is what is looked at.
function find_live() {
  const status = store.get('status');
  if (!status || store.get('shown') !== 'live') return null;
  return {branch: status.branch, increment: status.increment, is_running: status.phase === 'running'};
}
