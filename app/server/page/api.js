// SPDX-License-Identifier: GPL-3.0-or-later
// The program's HTTP API. The token travels in a cookie that scripts cannot read.

/// The same tab keeps its name when it is loaded again; a copy of a tab gets one of its own.
function find_viewer() {
  const kept = sessionStorage.getItem('viewer');
  const [navigation] = performance.getEntriesByType('navigation');
  if (kept && navigation?.type === 'reload') return kept;
  const bytes = crypto.getRandomValues(new Uint8Array(8));
  const fresh = 'v' + [...bytes].map((b) => b.toString(16).padStart(2, '0')).join('');
  sessionStorage.setItem('viewer', fresh);
  return fresh;
}

export const viewer = find_viewer();

/// status: of HTTP; 0 when the program was not reached.
export class ApiError extends Error {
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

/// Told of each answer's status (0: none), so that one place watches over the connection.
let watcher = () => {};
export function watch_answers(listener) {
  watcher = listener;
}

export function url(path, params = {}) {
  const query = new URLSearchParams({viewer});
  for (const [name, value] of Object.entries(params)) {
    if (value === undefined || value === null || value === false || value === '') continue;
    query.set(name, value === true ? '1' : String(value));
  }
  return `${path}?${query}`;
}

async function call(path, params, options) {
  let answer;
  try {
    answer = await fetch(url(path, params), {cache: 'no-store', credentials: 'same-origin', ...options});
  } catch (error) {
    if (error.name === 'AbortError') throw error;
    watcher(0);
    throw new ApiError(0, 'the program was not reached');
  }
  watcher(answer.status);
  if (answer.ok) return answer;
  throw new ApiError(answer.status, await read_error(answer));
}

async function read_error(answer) {
  const text = await answer.text().catch(() => '');
  try {
    return JSON.parse(text).error || text;
  } catch {
    return text.slice(0, 400) || `the program answered ${answer.status}`;
  }
}

export async function get(path, params = {}, signal = undefined) {
  return (await call(path, params, {signal})).json();
}

export async function get_text(path, params = {}) {
  return (await call(path, params, {})).text();
}

export async function post(path, params = {}, body = '') {
  return (await call(path, params, {method: 'POST', body, headers: {'Content-Type': 'text/plain'}})).json();
}

/// A picture with what its headers tell; null when there is none (newer one asked for, or nothing new).
export async function get_frame(params, signal) {
  const answer = await call('/api/frame', params, {signal});
  if (answer.status === 204) return null;
  const number = (name) => (answer.headers.has(name) ? Number(answer.headers.get(name)) : null);
  const range = (answer.headers.get('X-Range') || '').split(',').map(Number);
  const bitmap = await createImageBitmap(await answer.blob());
  return {
    bitmap,
    branch: number('X-Branch'),
    increment: number('X-Increment'),
    time: number('X-Time'),
    pressure: number('X-Pressure'),
    draw_ms: number('X-Draw-Ms'),
    range: range.length === 2 && range.every(Number.isFinite) && range[0] < range[1] ? range : null
  };
}
