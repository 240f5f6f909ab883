// SPDX-License-Identifier: GPL-3.0-or-later
// Orbiting as a user feels it: the page in headless Chromium, the mouse held down and moved. Not a test.
//   node tests/bench/drag_bench.mjs PROGRAM [ELEMENTS_AROUND ELEMENTS_ALONG]
// Prints the time between pictures that are shown while the mouse moves, the solver at rest and at work. The
// browser draws on the same cores. Needs what the browser tests need.
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { close_browser, open_page, type_command, wait_phase } from '../browser/browser.mjs';
import { Program, options } from '../browser/program.mjs';

const [program, around = '40', along = '100'] = process.argv.slice(2);
const work = mkdtempSync(join(tmpdir(), 'drag-bench-'));
Object.assign(options, { program, output: work });

const run = await Program.start('run', {
  subject: 'scenes/job-b-3d.toml', set: { 'tube.elements_around': around, 'tube.elements_along': along } });
const page = await open_page(run);

/// Moves the mouse for some seconds; the times between pictures in ms.
async function drag(seconds) {
  await page.evaluate(() => {
    window.shown = [];
    const surface = document.getElementById('surface-a');
    window.watcher = new MutationObserver(() => {
      if (surface.dataset.kind === 'drag' && surface.dataset.frames !== window.last) window.shown.push(performance.now());
      window.last = surface.dataset.frames;
    });
    window.watcher.observe(surface, { attributes: true, attributeFilter: ['data-frames'] });
  });
  const box = await page.locator('#surface-a').boundingBox();
  const x = box.x + box.width / 2, y = box.y + box.height / 2, end = performance.now() + 1000 * seconds;
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let k = 0; performance.now() < end; ++k) {
    await page.mouse.move(x + 200 * Math.sin(k / 40), y + 40 * Math.cos(k / 50));
    await new Promise((done) => setTimeout(done, 15));
  }
  await page.mouse.up();
  const times = await page.evaluate(() => (window.watcher.disconnect(), window.shown));
  return times.slice(1).map((t, i) => t - times[i]).sort((a, b) => a - b);
}

const report = (what, times) => console.log(`${what.padEnd(28)} median ${times[times.length >> 1]?.toFixed(0)} ms, ` +
  `95 % below ${times[Math.floor(0.95 * times.length)]?.toFixed(0)} ms (${times.length} pictures)`);

try {
  console.log(`${around} x ${along} shells, 1366 x 768 page`);
  await type_command(page, 'until pressure 12');
  await wait_phase(page, 'paused');
  report('solver at rest', await drag(6));
  await type_command(page, 'run');
  report('solver at work', await drag(12));
} finally {
  await close_browser();
  await run.stop?.();
  rmSync(work, { recursive: true, force: true });
}
