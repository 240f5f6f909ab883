// SPDX-License-Identifier: GPL-3.0-or-later
// Values of what is picked against the saved states; ledger, charts, finished runs.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {after, before, test} from 'node:test';
import {open_page, screenshot, text_of, type_command, wait_phase, wait_picture, wait_text} from './browser.mjs';
import {options, Program} from './program.mjs';
import {find_state} from './state_file.mjs';

const kClasses = ['free', 'stick', 'slip', 'detached now'];
let program = null,
  page = null;

before(async () => {
  program = await Program.start('inspecting');
  page = await open_page(program);
  await type_command(page, 'run');
  await program.wait_status((one) => one.phase === 'ended', 'the end');
  await page.waitForFunction(
    (count) => Number(document.getElementById('track').getAttribute('aria-valuemax')) >= count,
    (await program.get('/api/timeline?viewer=test')).kept.length
  );
  await page.click('#tab-inspect');
});

after(async () => {
  await page?.context().close();
  await program?.stop();
});

async function click_part(dx = 0, dy = 0, options = {}) {
  const box = await page.locator('#surface-a').boundingBox();
  await page.mouse.click(box.x + box.width * (0.45 + dx), box.y + box.height * (0.55 + dy), options);
}

/// What the table of values says, by the keys of the API.
function read_values() {
  return page.evaluate(() =>
    Object.fromEntries(
      [...document.querySelectorAll('#node-values td[data-key]')].map((cell) => [
        cell.dataset.key,
        cell.dataset.value === undefined ? cell.innerText.trim() : Number(cell.dataset.value)
      ])
    )
  );
}

test('a picked node shows what its saved state says', async () => {
  const {kept} = await program.get('/api/timeline?viewer=test');
  const goal = kept.filter((state) => state.pressure_MPa > 20).at(0);
  do await page.click('#before');
  while (!(await text_of(page, '#where')).startsWith(`increment ${goal.increment},`));
  await wait_picture(page, 'a', goal.increment);
  const state = find_state(program.results, goal.increment);
  const seen = new Set();
  for (const [dx, dy] of [
    [0.06, 0],
    [0.13, -0.1],
    [-0.02, 0.12]
  ]) {
    const before = await page.evaluate(() => document.querySelector('#node-values caption')?.textContent ?? '');
    await click_part(dx, dy);
    await page.waitForFunction(
      (before) => ![null, before].includes(document.querySelector('#node-values caption')?.textContent ?? null),
      before
    );
    const node = Number((await page.locator('#node-values caption').innerText()).match(/Node (\d+)/)[1]);
    seen.add(node);
    const shown = await read_values();
    for (const key of ['thickness_mm', 'plastic_strain', 'contact_pressure_MPa'])
      assert.equal(shown[key], state[key][node], `${key} of node ${node}`);
    if (Number.isFinite(state.gap_mm[node])) assert.equal(shown.gap_mm, state.gap_mm[node]);
    assert.equal(shown.contact, kClasses[state.contact_state[node]]);
    const [x, y, z] = state.contact_force_N[node],
      [nx, ny, nz] = state.tool_normal[node];
    if (state.contact_tool[node] >= 0)
      assert.ok(Math.abs(shown.normal_force_N - (x * nx + y * ny + z * nz)) < 1e-9 * (1 + Math.hypot(x, y, z)));
  }
  assert.ok(seen.size > 1, 'three places, one node');
  await page.waitForTimeout(800);
  await screenshot(page, '20-node');
});

test('a rectangle gathers nodes', async () => {
  const box = await page.locator('#surface-a').boundingBox();
  await page.keyboard.down('Control');
  await page.mouse.move(box.x + box.width * 0.35, box.y + box.height * 0.4);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.65, box.y + box.height * 0.75, {steps: 6});
  await page.mouse.up();
  await page.keyboard.up('Control');
  await page.locator('#many-nodes').waitFor();
  const count = Number((await text_of(page, '#inspect-body h3')).match(/(\d+) nodes/i)[1]);
  assert.ok(count > 4);
  const rows = await page.locator('#many-nodes tbody tr').count();
  assert.equal(rows, Math.min(60, count));
  await wait_text(page, '#many-nodes tbody tr:last-child', /free|stick|slip|detached/);
  await screenshot(page, '21-rectangle');
  await page.locator('#many-nodes tbody tr').nth(1).click();
  await page.locator('#node-values').waitFor();
});

test('the ledger is that of the command line; a click flies to the patch and its moment', async () => {
  const ledger = JSON.parse(
    execFileSync(options.program, ['inspect', program.results, '--json'], {maxBuffer: 1 << 28})
  );
  await page.click('#tab-ledger');
  await page.locator('#ledger-table tbody tr').first().waitFor();
  assert.equal(await page.locator('#ledger-table tbody tr').count(), ledger.patches.length);
  await page.click('#ledger-table th[data-key="node_count"] button');
  const counts = await page.locator('#ledger-table tbody tr td:nth-child(2)').allInnerTexts();
  assert.deepEqual(
    counts.map(Number),
    ledger.patches.map((patch) => patch.node_count).sort((a, b) => a - b)
  );
  await page.locator('#ledger-table tbody tr').last().focus();
  page.asked.length = 0;
  await page.keyboard.press('Enter');
  const most = ledger.patches.reduce((a, b) => (b.node_count > a.node_count ? b : a));
  await wait_text(page, '#ledger-reason', new RegExp(`Patch ${most.patch}: ${most.verdict}`));
  await page.waitForFunction(() => document.getElementById('live').getAttribute('aria-pressed') === 'false');
  await page.waitForTimeout(600);
  await wait_picture(page);
  const asked = new URL(page.asked.filter((one) => one.includes('/api/frame')).at(-1)).searchParams;
  most.centre_mm.forEach((value, i) => assert.ok(Math.abs(Number(asked.get(['fx', 'fy', 'fz'][i])) - value) < 1e-6));
  assert.ok(Number(asked.get('zoom')) > 1.2);
  const {kept} = await program.get('/api/timeline?viewer=test');
  const nearest = kept.reduce((a, b) =>
    Math.abs(b.time_s - most.first_time_s) < Math.abs(a.time_s - most.first_time_s) ? b : a
  );
  assert.equal(asked.get('state'), `0.${nearest.increment}`);
  await screenshot(page, '22-ledger');
});

test('charts have all rows of the history', async () => {
  await page.keyboard.press('l');
  await page.click('#tab-charts');
  const rows = program.table('history.csv');
  const counted = async () =>
    (await page.locator('#panel-charts .legend.wide span').allInnerTexts())
      .map((text) => Number(text.match(/(\d+)$/)?.[1] ?? 0))
      .reduce((a, b) => a + b, 0);
  await page.waitForFunction(() => document.querySelector('#panel-charts .legend.wide')?.textContent);
  assert.equal(await counted(), rows.length, 'each increment has its limiter');
  const chart = page.locator('#panel-charts .chart-canvas').first();
  await chart.hover({position: {x: 150, y: 50}});
  await wait_text(page, '#panel-charts figcaption output', /\d/);
  await screenshot(page, '23-charts');
});

test('a finished folder is looked at, not steered', async (t) => {
  await program.stop();
  const finished = await Program.start('', {subject: program.results});
  t.after(() => finished.stop());
  const viewer = await open_page(finished);
  t.after(() => viewer.context().close());
  await wait_text(viewer, '#wheel', /Finished run/);
  assert.ok(await viewer.locator('#run').isHidden());
  await viewer.waitForFunction(() => Number(document.getElementById('track').getAttribute('aria-valuemax')) > 5);
  await viewer.keyboard.press('[');
  await viewer.keyboard.press('[');
  await viewer.waitForFunction(() => document.getElementById('live').getAttribute('aria-pressed') === 'false');
  await viewer.keyboard.press('s');
  await wait_text(viewer, '#reply', /finished run/);
  await screenshot(viewer, '24-finished');
});
