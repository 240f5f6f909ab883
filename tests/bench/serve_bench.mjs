// SPDX-License-Identifier: GPL-3.0-or-later
// What a viewer feels, and what it costs the solver, through the whole server. Not a test.
//   node tests/bench/serve_bench.mjs PROGRAM [ELEMENTS_AROUND ELEMENTS_ALONG] [ROUNDS]
// A part of 4,000 shells is blown to 12 MPa; from there the same increments are solved again and again, with
// nobody there, with a viewer who watches, and with one who orbits, in turn.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [program, around = '40', along = '100', rounds = '3'] = process.argv.slice(2);
const kIncrements = 6;
const work = mkdtempSync(join(tmpdir(), 'serve-bench-'));

const server = spawn(program, ['serve', 'scenes/job-b-3d.toml', '--port', '0', '-o', join(work, 'run'), '--set',
  `tube.elements_around=${around}`, '--set', `tube.elements_along=${along}`], { stdio: ['ignore', 'pipe', 'inherit'] });
const url = await new Promise((done) => {
  let text = '';
  server.stdout.on('data', (piece) => {
    text += piece;
    const found = text.match(/http:\S+/);
    if (found) done(new URL(found[0]));
  });
});
const token = url.searchParams.get('token');

async function ask(path, options = {}) {
  const answer = await fetch(url.origin + path, { ...options, headers: { Authorization: `Bearer ${token}` } });
  if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
  return answer;
}
const status = async () => (await ask('/api/status?viewer=bench')).json();
const command = async (text) => (await ask('/api/command?viewer=bench', { method: 'POST', body: text })).json();
async function settle() {
  for (;;) {
    const now = await status();
    if (now.phase !== 'running') return now;
    await new Promise((done) => setTimeout(done, 100));
  }
}

const quantile = (values, q) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(q * values.length))];
const kDrag = 'view=contact-map&w=640&h=360&smooth=1&q=70', kRest = 'view=contact-map&w=960&h=540&smooth=2&q=85';

/// Frames one after the other until `is_over()`; latencies in ms.
async function look(query, isOver) {
  const times = [];
  for (let turn = 0; !isOver(times.length); turn += 3) {
    const begun = performance.now();
    const answer = await ask(`/api/frame?viewer=bench&slot=a&state=live&${query}&az=${turn % 360}`);
    await answer.arrayBuffer();
    times.push(performance.now() - begun);
  }
  return times;
}

/// As the page watches: one picture after the other, each when there is a newer state.
async function watch(isOver) {
  let seen = -1, pictures = 0;
  while (!isOver()) {
    const answer = await ask(`/api/frame?viewer=bench&slot=a&state=live&${kRest}&after=${seen}`);
    if (answer.status === 200) {
      seen = Number(answer.headers.get('X-Increment'));
      ++pictures;
    }
    await answer.arrayBuffer();
  }
  return pictures;
}

const report = (what, times) =>
  console.log(`${what.padEnd(42)} median ${quantile(times, 0.5).toFixed(0)} ms, 95 % below ${quantile(times, 0.95).toFixed(0)} ms (${times.length})`);

try {
  await command('until pressure 12');
  const from = await settle();
  console.log(`${around} x ${along} shells, from increment ${from.increment}, ${kIncrements} increments a round`);
  report('orbit at rest, 640 x 360', await look(kDrag, (n) => n >= 60));
  report('full picture at rest, 960 x 540 smoothed', await look(kRest, (n) => n >= 20));

  const solve = { nobody: [], watched: [], orbited: [] }, orbit = [];
  for (let round = 0; round < Number(rounds); ++round) {
    for (const kind of Object.keys(solve)) {
      await command(`back ${from.increment}`);
      const before = await settle();
      let isDone = false;
      const viewer = kind === 'watched' ? watch(() => isDone) : kind === 'orbited' ? look(kDrag, () => isDone) : null;
      await command(`step ${kIncrements}`);
      const after = await settle();
      isDone = true;
      solve[kind].push(after.solver_s - before.solver_s);
      if (kind === 'watched') await command(`back ${from.increment}`);  // something new, so that it looks up
      const seen = await viewer;
      if (kind === 'orbited') orbit.push(...seen);
    }
  }
  report('orbit while solving, 640 x 360', orbit);
  for (const kind of Object.keys(solve)) {
    const ratios = solve[kind].map((s, i) => s / solve.nobody[i]);
    console.log(`solver, ${kind}: ${solve[kind].map((s) => s.toFixed(2)).join(' ')} s; ` +
      `against nobody ${((quantile(ratios, 0.5) - 1) * 100).toFixed(0)} %`);
  }
} finally {
  server.kill('SIGINT');
  await new Promise((done) => server.on('exit', done));
  rmSync(work, { recursive: true, force: true });
}
