// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as engineers read them.

/// Four significant digits; powers of ten beyond 1e-4 and 1e6. Unknown values are a dash.
export function format(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return '–';
  if (Math.abs(value) < 1e-12) return '0';
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e6)
    return value
      .toExponential(digits - 1)
      .replace(/\.?0+e/, 'e')
      .replace('e+', 'e')
      .replace('-', '−')
      .replace('e-', 'e−');
  return trim(value.toPrecision(digits)).replace('-', '−');
}

function trim(text) {
  if (text.includes('e')) return String(Number(text));
  return text.includes('.') ? text.replace(/0+$/, '').replace(/\.$/, '') : text;
}

/// Fixed decimals, for read-outs that must not jump about.
export function fixed(value, decimals) {
  return value === null || value === undefined || !Number.isFinite(value)
    ? '–'
    : value.toFixed(decimals).replace('-', '−');
}

/// The nearest of 1, 2, 5 times a power of ten.
export function round_step(step) {
  const power = 10 ** Math.floor(Math.log10(step)),
    factor = step / power;
  return power * (factor < Math.SQRT2 ? 1 : factor < Math.sqrt(10) ? 2 : factor < Math.sqrt(50) ? 5 : 10);
}

/// Round numbers from low to high, about `count` of them.
export function ticks(low, high, count) {
  if (!(high > low)) return [low];
  const step = round_step((high - low) / Math.max(1, count));
  const list = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k) list.push(k * step);
  return list;
}

/// Labels of ticks with as many decimals as their step needs.
export function tick_text(value, step) {
  const size = Math.max(Math.abs(value), Math.abs(step));
  if (size >= 1e6 || (step < 1e-4 && size < 1e-3))
    return value === 0 ? '0' : Number(value.toPrecision(3)).toExponential().replace('e+', 'e').replace('-', '−');
  const decimals = Math.max(0, Math.min(8, -Math.floor(Math.log10(step) + 1e-9)));
  return value.toFixed(decimals).replace('-', '−');
}

export function duration(seconds) {
  if (!Number.isFinite(seconds)) return '–';
  if (seconds < 100) return `${seconds.toFixed(seconds < 10 ? 1 : 0)} s`;
  const minutes = Math.floor(seconds / 60);
  return minutes < 60 ? `${minutes} min` : `${Math.floor(minutes / 60)} h ${minutes % 60} min`;
}
