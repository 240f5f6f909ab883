// SPDX-License-Identifier: GPL-3.0-or-later
// Start, halt, change, branch, and who may.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import path from 'node:path';
import {test} from 'node:test';
import {open_page, screenshot, text_of, type_command, wait_phase, wait_picture, wait_text} from './browser.mjs';
import {options, Program} from './program.mjs';

async function run_until(page, kind, value = null) {
  await page.click('#until');
  await page.selectOption('#until-kind', kind);
  if (value !== null) await page.fill('#until-value', String(value));
  await page.click('#until-go');
  await page.waitForSelector('#until-form', {state: 'hidden'});
}

test('a run starts, halts at the first touch, and pauses', async (t) => {
  const program = await Program.start('touch');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await run_until(page, 'touch');
  const status = await program.wait_status(
    (one) => one.phase === 'paused' && one.n_contact > 0,
    'halt at the first touch'
  );
  const touches = program.table('events.csv').filter((row) => row.kind === 'touch');
  assert.equal(status.increment, Number(touches[0].increment), 'it must halt in the increment of the first touch');
  await wait_text(page, '#readout-increment', new RegExp(`^${status.increment}`));
  await wait_picture(page, 'a', status.increment);
  await screenshot(page, '03-first-touch');
  await page.click('#step');
  await program.wait_status(
    (one) => one.increment === status.increment + 1 && one.phase === 'paused',
    'one increment more'
  );
  await page.click('#run');
  await wait_phase(page, 'running');
  await page.click('#run');
  await wait_phase(page, 'paused');
  const words = program
    .journal()
    .map((line) => JSON.stringify(line))
    .join('\n');
  for (const word of ['until touch', 'step', 'run', 'pause'])
    assert.ok(words.includes(word), `${word} is not in the journal:\n${words}`);
});

test('a bad value is refused beside its field, a good one is taken and journalled', async (t) => {
  const program = await Program.start('set');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await page.click('#tab-change');
  const row = page.locator('form.set[data-key="tool.die.friction"]');
  await row.locator('input').fill('slippery');
  await row.locator('button').click();
  await row.locator('.note.error').waitFor();
  assert.match(await row.locator('.note').innerText(), /friction/);
  assert.equal(await row.locator('input').getAttribute('aria-invalid'), 'true');
  await screenshot(page, '04-bad-value');
  await row.locator('input').fill('0.12');
  await row.locator('input').press('Enter');
  await row.locator('.note.good').waitFor();
  assert.equal(await row.locator('input').getAttribute('aria-invalid'), 'false');
  const words = program
    .journal()
    .map((line) => JSON.stringify(line))
    .join('\n');
  assert.ok(words.includes('set tool.die.friction 0.12'), words);
  assert.ok(!words.includes('slippery'), 'what was refused is not an act');
  assert.match(await type_command(page, 'untill touch'), /until/, 'the console names the nearest word');
});

test('back to a kept state and on from there: a branch', async (t) => {
  const program = await Program.start('branch');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await run_until(page, 'pressure', 14);
  const first = await program.wait_status((one) => one.phase === 'paused' && one.pressure_MPa > 13.9, '14 MPa');
  const {kept} = await program.get('/api/timeline?viewer=test');
  const goal = kept
    .filter((state) => state.can_restore && state.increment > 0 && state.increment < first.increment)
    .at(-1);
  assert.ok(goal, 'no kept state to go back to');
  await page.waitForFunction(
    (count) => Number(document.getElementById('track').getAttribute('aria-valuemax')) >= count,
    kept.length
  );
  do await page.click('#before');
  while (!(await text_of(page, '#where')).startsWith(`increment ${goal.increment},`));
  await wait_picture(page, 'a', goal.increment);
  await page.click('#branch');
  const back = await program.wait_status((one) => one.branch === 1, 'branch 1');
  assert.equal(back.increment, goal.increment);
  assert.equal(back.time_s, goal.time_s);
  await page.click('#step');
  await page.click('#step');
  await program.wait_status(
    (one) => one.branch === 1 && one.increment === goal.increment + 2,
    'two increments of the branch'
  );
  await run_until(page, 'pressure', 15);
  await program.wait_status((one) => one.branch === 1 && one.phase === 'paused' && one.pressure_MPa > 14.9, '15 MPa');
  const branches = new Set((await program.get('/api/timeline?viewer=test')).kept.map((state) => state.branch));
  assert.deepEqual([...branches].sort(), [0, 1]);
  await page.waitForTimeout(1000);
  await screenshot(page, '05-branch');
  assert.ok(program.journal().some((line) => JSON.stringify(line).includes(`back ${goal.increment}`)));
});

test('of two viewers one steers, until the other takes the wheel', async (t) => {
  const program = await Program.start('viewers');
  t.after(() => program.stop());
  const first = await open_page(program),
    second = await open_page(program, {width: 1200, height: 700});
  t.after(() => Promise.all([first.context().close(), second.context().close()]));
  await wait_text(second, '#wheel', /Another viewer steers/);
  assert.ok(await second.locator('#run').isDisabled());
  await second.keyboard.press('s');
  await wait_text(second, '#reply', /Take the wheel/);
  assert.equal((await program.status()).increment, 0, 'the second must not step');
  await screenshot(second, '06-second-viewer');
  await second.click('#take');
  await second.click('dialog button[value="take"]');
  await wait_text(second, '#wheel', /You steer/);
  await wait_text(first, '#wheel', /Another viewer steers/);
  assert.ok(await first.locator('#run').isDisabled());
  await second.click('#step');
  await wait_picture(first, 'a', 1);
  assert.equal((await program.status()).increment, 1);
  await second.reload();
  await wait_picture(second, 'a', 1);
  await wait_text(second, '#wheel', /You steer/); // the same tab is the same viewer
});

test('warnings come as notices and stay in their list', async (t) => {
  const program = await Program.start('warnings', {subject: path.join(options.folder, '../../scenes/free-bulge.toml')});
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await page.click('#run');
  await page.locator('.toast').first().waitFor();
  assert.match(await page.locator('.toast').first().innerText(), /necking/);
  await program.wait_status((one) => one.phase === 'ended', 'the end');
  const {warnings} = JSON.parse(fs.readFileSync(path.join(program.results, 'summary.json'), 'utf8'));
  await wait_text(page, '#tab-warnings', new RegExp(`${warnings.length}$`));
  await page.click('#tab-warnings');
  const shown = await page.locator('#warning-list li').allInnerTexts();
  assert.equal(shown.length, warnings.length);
  for (const warning of warnings)
    assert.ok(
      shown.some((text) => text.includes(warning.text)),
      warning.text
    );
  await wait_picture(page);
  await screenshot(page, '09-warning');
});

test('the browser closes in mid-run, the run goes on and loses nothing', async (t) => {
  const program = await Program.start('closed', {set: {'increment.largest': 0.001}});
  t.after(() => program.stop());
  const page = await open_page(program);
  await page.click('#run');
  const seen = await program.wait_status((one) => one.increment > 5, 'a few increments');
  await page.context().close();
  assert.equal((await program.status()).phase, 'running', 'it was closed too late');
  const ended = await program.wait_status((one) => one.phase === 'ended', 'the end of the path');
  assert.ok(seen.increment < ended.increment);
  const rows = program.table('history.csv').map((row) => Number(row.increment));
  assert.deepEqual(
    rows,
    Array.from({length: ended.increment}, (_, i) => i + 1)
  );
  const again = await open_page(program);
  t.after(() => again.context().close());
  await wait_text(again, '#phase', /Ended: completed/);
  await again.click('#tab-charts');
  await again.waitForTimeout(1200);
  await screenshot(again, '07-after-the-end');
  const code = await program.stop();
  assert.equal(code, 0);
  assert.ok(fs.existsSync(path.join(program.results, 'summary.json')));
});

test('a lost program is told, and buttons are disabled', async (t) => {
  const program = await Program.start('lost');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await program.stop();
  await wait_text(page, '#notice', /connection to the program is lost/);
  await page.waitForFunction(() => document.getElementById('run').disabled);
  await screenshot(page, '08-lost');
});
