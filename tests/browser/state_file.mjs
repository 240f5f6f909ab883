// SPDX-License-Identifier: GPL-3.0-or-later
// Saved states read without the program: VTK PolyData with raw appended arrays.
import fs from 'node:fs';
import path from 'node:path';

const kReaders = {Float64: [8, 'readDoubleLE'], Int32: [4, 'readInt32LE'], UInt8: [1, 'readUInt8']};

/// Arrays by name; those with components are arrays of arrays.
export function read_state(file) {
  const bytes = fs.readFileSync(file);
  const mark = Buffer.from('<AppendedData encoding="raw">');
  const start = bytes.indexOf('_', bytes.indexOf(mark)) + 1;
  const xml = bytes.subarray(0, start).toString('latin1');
  const arrays = {};
  for (const [, text] of xml.matchAll(/<DataArray ([^>]*)\/>/g)) {
    const attribute = Object.fromEntries(
      [...text.matchAll(/(\w+)="([^"]*)"/g)].map(([, name, value]) => [name, value])
    );
    if (attribute.format !== 'appended') continue;
    arrays[attribute.Name] = read_array(bytes, start + Number(attribute.offset), attribute);
  }
  return arrays;
}

function read_array(bytes, at, attribute) {
  const [size, reader] = kReaders[attribute.type] ?? [];
  if (!size) return null;
  const count = Number(bytes.readBigUInt64LE(at)) / size,
    width = Number(attribute.NumberOfComponents ?? 1);
  const values = Array.from({length: count}, (_, i) => bytes[reader](at + 8 + i * size));
  return width === 1 ? values : Array.from({length: count / width}, (_, i) => values.slice(i * width, (i + 1) * width));
}

/// The saved state of an increment.
export function find_state(results, increment) {
  const folder = path.join(results, 'states');
  for (const name of fs.readdirSync(folder).filter((one) => one.endsWith('.vtp'))) {
    const state = read_state(path.join(folder, name));
    if (state.increment[0] === increment) return state;
  }
  throw new Error(`no saved state of increment ${increment} in ${folder}`);
}
