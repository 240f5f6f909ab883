// SPDX-License-Identifier: GPL-3.0-or-later
// A line chart on a canvas: round axes, several series, a marked place, a read-out under pointer or arrow keys.
import {el, set_text} from './dom.js';
import {format, tick_text, ticks} from './numbers.js';
import {colour} from './theme.js';

const kLeft = 52,
  kRight = 10,
  kTop = 8,
  kBottom = 20;

export class LineChart {
  #series = [];
  #cursor = null; // index into the x of the first series
  #marked = null;

  /// title with unit; x_title; is_log; height [px]; pick(x) on click.
  constructor({title, x_title = 'time [s]', is_log = false, height = 120, pick = null, is_step = false}) {
    Object.assign(this, {title, x_title, is_log, pick, is_step});
    this.canvas = el('canvas', {
      class: 'chart-canvas',
      tabindex: '0',
      role: 'img',
      'data-keys': true,
      'aria-label': title
    });
    this.canvas.style.height = `${height}px`;
    this.readout = el('output', {class: 'value'});
    this.legend = el('span', {class: 'legend'});
    this.root = el(
      'figure',
      {class: 'chart'},
      el('figcaption', {}, el('span', {}, title), this.legend, this.readout),
      this.canvas
    );
    this.canvas.addEventListener('pointermove', (event) => this.#hover(event));
    this.canvas.addEventListener('pointerleave', () => this.#set_cursor(null));
    this.canvas.addEventListener('blur', () => this.#set_cursor(null));
    this.canvas.addEventListener('click', () => this.#choose());
    this.canvas.addEventListener('keydown', (event) => this.#key(event));
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  /// series: [{name, colour (of the style sheet), x: [], y: []}]; marked: x of the shown state.
  show(series, marked = null) {
    this.#series = series;
    this.#marked = marked;
    this.legend.replaceChildren(
      ...(series.length > 1
        ? series.map((one) => {
            const swatch = el('i', {class: 'swatch'});
            swatch.style.background = colour(one.colour);
            return el('span', {}, swatch, one.name);
          })
        : [])
    );
    this.draw();
  }

  #scale() {
    const width = this.canvas.clientWidth,
      height = this.canvas.clientHeight;
    const xs = this.#series.flatMap((one) => one.x).filter(Number.isFinite);
    const ys = this.#series.flatMap((one) => one.y).filter((y) => Number.isFinite(y) && (!this.is_log || y > 0));
    if (!xs.length || !ys.length) return null;
    let [x0, x1] = [least(xs), -least(xs.map((x) => -x))],
      [y0, y1] = [least(ys), -least(ys.map((y) => -y))];
    if (x0 === x1) x1 = x0 + 1;
    if (this.is_log) {
      [y0, y1] = [Math.floor(Math.log10(y0)), Math.ceil(Math.log10(y1))];
      if (y0 === y1) y1 += 1;
    } else {
      if (y1 - y0 < 1e-9 * Math.max(Math.abs(y0), Math.abs(y1), 1e-12))
        [y0, y1] = y0 === 0 ? [0, 1] : [y0 - 0.01 * Math.abs(y0), y0 + 0.01 * Math.abs(y0)];
      const marks = ticks(y0, y1, 4),
        step = marks.length > 1 ? marks[1] - marks[0] : y1 - y0;
      [y0, y1] = [step * Math.floor(y0 / step + 1e-9), step * Math.ceil(y1 / step - 1e-9)];
    }
    const inner = Math.max(10, width - kLeft - kRight),
      tall = Math.max(10, height - kTop - kBottom);
    return {
      width,
      height,
      x0,
      x1,
      y0,
      y1,
      to_x: (x) => kLeft + (inner * (x - x0)) / (x1 - x0),
      from_x: (px) => x0 + ((px - kLeft) / inner) * (x1 - x0),
      to_y: (y) => kTop + tall * (1 - ((this.is_log ? Math.log10(y) : y) - y0) / (y1 - y0))
    };
  }

  draw() {
    const context = start_canvas(this.canvas);
    if (!context) return;
    const scale = this.#scale();
    if (!scale) {
      context.fillStyle = colour('faint');
      context.fillText('no values yet', kLeft, this.canvas.clientHeight / 2);
      return;
    }
    this.#draw_axes(context, scale);
    if (this.#marked !== null) draw_upright(context, scale.to_x(this.#marked), scale, colour('accent'), []);
    for (const one of this.#series) this.#draw_line(context, scale, one);
    if (this.#cursor !== null)
      draw_upright(context, scale.to_x(this.#series[0].x[this.#cursor]), scale, colour('faint'), [3, 3]);
  }

  #draw_axes(context, scale) {
    context.strokeStyle = colour('grid');
    context.fillStyle = colour('faint');
    context.lineWidth = 1;
    context.textBaseline = 'middle';
    context.textAlign = 'right';
    const y_marks = this.is_log ? log_marks(scale.y0, scale.y1) : ticks(scale.y0, scale.y1, 4);
    for (const mark of y_marks) {
      const y = Math.round(scale.to_y(mark)) + 0.5;
      line(context, kLeft, y, scale.width - kRight, y);
      context.fillText(
        this.is_log ? power_text(mark) : tick_text(mark, y_marks.length > 1 ? y_marks[1] - y_marks[0] : mark || 1),
        kLeft - 5,
        y
      );
    }
    const x_marks = ticks(scale.x0, scale.x1, Math.max(2, Math.floor((scale.width - kLeft) / 55)));
    context.textBaseline = 'top';
    context.textAlign = 'center';
    const bottom = scale.height - kBottom;
    for (const mark of x_marks) {
      const x = Math.round(scale.to_x(mark)) + 0.5;
      line(context, x, bottom, x, bottom + 4);
      if (x < scale.width - 66)
        context.fillText(tick_text(mark, x_marks.length > 1 ? x_marks[1] - x_marks[0] : mark || 1), x, bottom + 6);
    }
    context.textAlign = 'right';
    context.fillText(this.x_title, scale.width - 2, bottom + 6);
  }

  #draw_line(context, scale, one) {
    context.strokeStyle = colour(one.colour);
    context.fillStyle = context.strokeStyle;
    context.lineWidth = 1.6;
    context.lineJoin = 'round';
    context.beginPath();
    let is_down = false,
      last_y = 0;
    for (let i = 0; i < one.x.length; ++i) {
      const value = one.y[i];
      if (!Number.isFinite(value) || value === null || (this.is_log && !(value > 0))) {
        is_down = false;
        continue;
      }
      const x = scale.to_x(one.x[i]),
        y = scale.to_y(value);
      if (is_down && this.is_step) context.lineTo(x, last_y);
      if (is_down) context.lineTo(x, y);
      else context.moveTo(x, y);
      is_down = true;
      last_y = y;
    }
    context.stroke();
    if (one.x.length > 60) return;
    for (let i = 0; i < one.x.length; ++i)
      if (Number.isFinite(one.y[i]) && one.y[i] !== null && (!this.is_log || one.y[i] > 0))
        dot(context, scale.to_x(one.x[i]), scale.to_y(one.y[i]), 2);
  }

  #hover(event) {
    const scale = this.#scale();
    if (!scale) return;
    const x = scale.from_x(event.clientX - this.canvas.getBoundingClientRect().left);
    this.#set_cursor(nearest(this.#series[0].x, x));
  }

  #set_cursor(index) {
    if (this.#cursor === index) return;
    this.#cursor = index;
    const at =
      index === null
        ? ''
        : this.#series
            .map((one) => `${this.#series.length > 1 ? `${one.name} ` : ''}${format(one.y[index])}`)
            .join('  ');
    set_text(this.readout, index === null ? '' : `${format(this.#series[0].x[index])}: ${at}`);
    this.draw();
  }

  #key(event) {
    const step = {ArrowLeft: -1, ArrowRight: 1}[event.key],
      xs = this.#series[0]?.x ?? [];
    if (event.key === 'Enter') return this.#choose();
    if (!step || !xs.length) return;
    event.preventDefault();
    const from = this.#cursor ?? (this.#marked === null ? xs.length - 1 : nearest(xs, this.#marked));
    this.#set_cursor(Math.min(xs.length - 1, Math.max(0, from + step)));
  }

  #choose() {
    if (this.pick && this.#cursor !== null) this.pick(this.#series[0].x[this.#cursor]);
  }
}

/// A canvas in device pixels, cleared, drawn on in page pixels; null while it has no size.
export function start_canvas(canvas) {
  const dpr = window.devicePixelRatio || 1,
    width = canvas.clientWidth,
    height = canvas.clientHeight;
  if (!width || !height) return null;
  if (canvas.width !== Math.round(width * dpr) || canvas.height !== Math.round(height * dpr)) {
    canvas.width = Math.round(width * dpr);
    canvas.height = Math.round(height * dpr);
  }
  const context = canvas.getContext('2d');
  context.setTransform(dpr, 0, 0, dpr, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = '11px system-ui, "DejaVu Sans", sans-serif';
  return context;
}

export function dot(context, x, y, radius) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}

export function line(context, x0, y0, x1, y1) {
  context.beginPath();
  context.moveTo(x0, y0);
  context.lineTo(x1, y1);
  context.stroke();
}

/// Index of the value nearest to x.
export function nearest(values, x) {
  let best = 0;
  for (let i = 1; i < values.length; ++i) if (Math.abs(values[i] - x) < Math.abs(values[best] - x)) best = i;
  return best;
}

function draw_upright(context, x, scale, stroke, dash) {
  context.strokeStyle = stroke;
  context.lineWidth = 1.2;
  context.setLineDash(dash);
  line(context, x, kTop, x, scale.height - kBottom);
  context.setLineDash([]);
}

function least(values) {
  return values.reduce((a, b) => Math.min(a, b), Infinity);
}

function log_marks(low, high) {
  const every = Math.max(1, Math.ceil((high - low) / 4)),
    marks = [];
  for (let k = low; k <= high; k += every) marks.push(10 ** k);
  return marks;
}

function power_text(value) {
  const digits = {'-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹'};
  return '10' + [...String(Math.round(Math.log10(value)))].map((c) => digits[c]).join('');
}
