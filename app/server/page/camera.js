// SPDX-License-Identifier: GPL-3.0-or-later
// The camera as values: azimuth and elevation [deg], zoom, pan [heights of the unzoomed picture], focus [mm].
// y is up; azimuth 0 looks from +x, 90 from +z. Nothing here touches the page.

export const kHome = Object.freeze({az: 35, el: 25, zoom: 1, px: 0, py: 0, focus: null});
const kLeastZoom = 0.1,
  kMostZoom = 200;

/// Name, key and direction of the standard views.
export const kStandardViews = [
  {name: 'Iso', key: '1', az: 35, el: 25},
  {name: 'Front', key: '2', az: 90, el: 0, from: '+z'},
  {name: 'Back', key: '3', az: 270, el: 0, from: '−z'},
  {name: 'Right', key: '4', az: 0, el: 0, from: '+x'},
  {name: 'Left', key: '5', az: 180, el: 0, from: '−x'},
  {name: 'Top', key: '6', az: 90, el: 90, from: '+y'},
  {name: 'Bottom', key: '7', az: 90, el: -90, from: '−y'}
];

const clamp = (value, low, high) => Math.min(high, Math.max(low, value));
const wrap = (degrees) => ((degrees % 360) + 360) % 360;

/// The part follows the pointer.
export function orbit(camera, right_px, down_px) {
  return {...camera, az: wrap(camera.az + 0.4 * right_px), el: clamp(camera.el + 0.4 * down_px, -90, 90)};
}

export function pan(camera, right_px, down_px, height_px) {
  return {
    ...camera,
    px: camera.px - right_px / height_px / camera.zoom,
    py: camera.py + down_px / height_px / camera.zoom
  };
}

/// `u`, `v`: what stays in place, from the middle, right and up [heights of the picture].
export function zoom_at(camera, factor, u = 0, v = 0) {
  const zoom = clamp(camera.zoom * factor, kLeastZoom, kMostZoom);
  const gain = 1 / camera.zoom - 1 / zoom;
  return {...camera, zoom, px: camera.px + u * gain, py: camera.py + v * gain};
}

export function look_from(camera, view) {
  return {...camera, az: view.az, el: view.el};
}

/// Straight at a place, so near that `size` [mm] fills a third of the picture of a part of `extent` [mm].
export function fly_to(camera, place, size, extent) {
  const zoom = clamp(extent / (3 * Math.max(size, extent / 60)), 1.5, 20);
  return {...camera, focus: place, px: 0, py: 0, zoom};
}

/// Looks from `outward` unless what faces there is seen well enough already (within 65 degrees).
export function turn_towards(camera, outward) {
  const size = Math.hypot(...outward),
    [a, e] = [camera.az, camera.el].map((degrees) => (degrees * Math.PI) / 180);
  const direction = [Math.cos(a) * Math.cos(e), Math.sin(e), Math.sin(a) * Math.cos(e)];
  const cosine = outward.reduce((sum, value, i) => sum + value * direction[i], 0) / size;
  if (!(size > 0) || cosine > 0.42) return camera;
  const tilted = outward.map((value, i) => value / size + [0.25, 0.35, 0.45][i]),
    length = Math.hypot(...tilted);
  const degrees = (radians) => (radians * 180) / Math.PI;
  return {
    ...camera,
    az: wrap(degrees(Math.atan2(tilted[2], tilted[0]))),
    el: clamp(degrees(Math.asin(tilted[1] / length)), -90, 90)
  };
}

export function camera_params(camera) {
  const round = (value, digits) => Number(value.toFixed(digits));
  const params = {
    az: round(camera.az, 3),
    el: round(camera.el, 3),
    zoom: Number(camera.zoom.toPrecision(6)),
    px: round(camera.px, 6),
    py: round(camera.py, 6)
  };
  if (camera.focus) [params.fx, params.fy, params.fz] = camera.focus;
  return params;
}
