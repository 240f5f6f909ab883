// SPDX-License-Identifier: GPL-3.0-or-later
// Mouse, pen, fingers and wheel over a picture, told as what they mean.

const kClick = 4; // [px] that a hand may tremble

/// to: {orbit(dx, dy), pan(dx, dy), zoom(factor, x, y), click(x, y), box(x0, y0, x1, y1, is_done), start(), home()}
export function attach_gestures(surface, to) {
  const fingers = new Map();
  let drag = null;

  const place = (event) => {
    const box = surface.getBoundingClientRect();
    return {x: event.clientX - box.left, y: event.clientY - box.top};
  };

  function find_mode(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return 'box';
    return event.button === 1 || event.button === 2 || event.shiftKey ? 'pan' : 'orbit';
  }

  surface.addEventListener('pointerdown', (event) => {
    if (event.button > 2) return;
    surface.setPointerCapture(event.pointerId);
    const at = place(event);
    fingers.set(event.pointerId, at);
    drag =
      fingers.size === 2
        ? {mode: 'pinch', ...measure(fingers)}
        : {mode: find_mode(event), from: at, last: at, has_moved: false};
    to.start();
  });

  surface.addEventListener('pointermove', (event) => {
    if (!drag || !fingers.has(event.pointerId)) return;
    const at = place(event);
    fingers.set(event.pointerId, at);
    if (drag.mode === 'pinch') return pinch();
    if (Math.hypot(at.x - drag.from.x, at.y - drag.from.y) > kClick) drag.has_moved = true;
    if (!drag.has_moved) return;
    const dx = at.x - drag.last.x,
      dy = at.y - drag.last.y;
    drag.last = at;
    if (drag.mode === 'box') to.box(drag.from.x, drag.from.y, at.x, at.y, false);
    else if (drag.mode === 'pan') to.pan(dx, dy);
    else to.orbit(dx, dy);
  });

  function pinch() {
    if (fingers.size < 2) return;
    const now = measure(fingers);
    to.pan(now.x - drag.x, now.y - drag.y);
    if (drag.span > 0 && now.span > 0) to.zoom(now.span / drag.span, now.x, now.y);
    Object.assign(drag, now);
  }

  function end(event) {
    if (!fingers.delete(event.pointerId) || !drag) return;
    const ended = drag;
    drag = null;
    if (event.type === 'pointercancel' || ended.mode === 'pinch') {
      if (ended.mode === 'box') to.box(0, 0, 0, 0, null);
      return;
    }
    if (ended.mode === 'box' && ended.has_moved) to.box(ended.from.x, ended.from.y, ended.last.x, ended.last.y, true);
    else if (!ended.has_moved && event.button === 0) to.click(ended.from.x, ended.from.y);
  }
  surface.addEventListener('pointerup', end);
  surface.addEventListener('pointercancel', end);
  surface.addEventListener('mousedown', (event) => {
    if (event.button === 1) event.preventDefault();
  }); // no autoscroll
  surface.addEventListener('contextmenu', (event) => event.preventDefault());
  surface.addEventListener('dblclick', () => to.home());

  surface.addEventListener(
    'wheel',
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : event.deltaMode === 2 ? 400 : 1;
      // A pinch on a trackpad comes as a wheel with ctrl and small steps.
      const speed = event.ctrlKey ? 0.01 : 0.0015;
      const at = place(event);
      to.zoom(Math.exp(-event.deltaY * lines * speed), at.x, at.y);
    },
    {passive: false}
  );
}

function measure(fingers) {
  const [a, b] = [...fingers.values()];
  return {x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, span: Math.hypot(a.x - b.x, a.y - b.y)};
}
