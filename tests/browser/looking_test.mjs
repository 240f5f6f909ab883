// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures: camera, cut, time, downloads, themes, keys.
import assert from 'node:assert/strict';
import fs from 'node:fs';
import {after, before, test} from 'node:test';
import {
  change_picture,
  open_page,
  read_picture,
  screenshot,
  text_of,
  type_command,
  wait_phase,
  wait_picture,
  wait_text
} from './browser.mjs';
import {Program} from './program.mjs';

let program = null,
  page = null,
  kept = [];

before(async () => {
  program = await Program.start('looking');
  page = await open_page(program);
  await type_command(page, 'until pressure 20');
  await program.wait_status((one) => one.phase === 'paused' && one.pressure_MPa > 19.9, '20 MPa');
  kept = (await program.get('/api/timeline?viewer=test')).kept;
  await page.waitForFunction(
    (count) => Number(document.getElementById('track').getAttribute('aria-valuemax')) >= count,
    kept.length
  );
  await page.click('#tab-inspect');
});

after(async () => {
  await page?.context().close();
  await program?.stop();
});

async function middle(slot = 'a') {
  const box = await page.locator(`#surface-${slot}`).boundingBox();
  return {x: box.x + box.width / 2, y: box.y + box.height / 2, ...{width: box.width, height: box.height}};
}

async function drag(dx, dy, options = {}) {
  const at = await middle();
  await page.mouse.move(at.x, at.y);
  await page.mouse.down(options);
  for (let i = 1; i <= 12; ++i) await page.mouse.move(at.x + (dx * i) / 12, at.y + (dy * i) / 12);
  await page.mouse.up(options);
}

test('dragging turns the part with small pictures, one at a time, and ends with a full one', async () => {
  await wait_picture(page, 'a', (await program.status()).increment);
  const first = await read_picture(page);
  let under_way = 0,
    most = 0;
  const sizes = [];
  const is_frame = (request) => request.url().includes('/api/frame');
  page.on('request', (request) => {
    if (!is_frame(request)) return;
    most = Math.max(most, ++under_way);
    sizes.push(Number(new URL(request.url()).searchParams.get('w')));
  });
  for (const event of ['requestfinished', 'requestfailed'])
    page.on(event, (request) => {
      if (is_frame(request)) --under_way;
    });
  await change_picture(page, () => drag(150, 40));
  const turned = await read_picture(page);
  assert.notEqual(turned.sum, first.sum, 'the picture did not change');
  assert.equal(most, 1, 'more than one picture was asked for at a time');
  assert.ok(Math.min(...sizes) <= 640 && sizes.at(-1) > 640, `widths asked for: ${sizes}`);
  await change_picture(page, async () => {
    await page.keyboard.press('1');
    await page.keyboard.press('f');
  });
  assert.equal((await read_picture(page)).sum, first.sum, 'back at the first direction the picture is another');
});

test('wheel, pan, cut, tools, mesh and mirror change the picture', async () => {
  const sums = new Set([(await read_picture(page)).sum]);
  const acts = {
    wheel: async () => {
      const at = await middle();
      await page.mouse.move(at.x + 80, at.y - 40);
      await page.mouse.wheel(0, -240);
    },
    pan: async () => {
      await page.keyboard.down('Shift');
      await drag(60, 30);
      await page.keyboard.up('Shift');
    },
    cut: () => page.selectOption('#clip', 'z'),
    'place of the cut': () => page.locator('#slider-share').fill('0.25'),
    'other side': () => page.click('#toggle-flip'),
    'no cut': () => page.selectOption('#clip', ''),
    tools: () => page.locator('#slider-opacity').fill('0.9'),
    mesh: () => page.click('#toggle-edges'),
    mirror: () => page.click('#toggle-mirror')
  };
  for (const [name, act] of Object.entries(acts)) {
    await change_picture(page, act);
    const {sum} = await read_picture(page);
    if (name !== 'no cut') assert.ok(!sums.has(sum), `${name}: the picture did not change`);
    sums.add(sum);
    if (name === 'other side') await screenshot(page, '10-cut');
  }
  await page.click('#toggle-edges');
  await page.click('#toggle-mirror');
  await page.locator('#slider-opacity').fill('0.35');
  await change_picture(page, async () => {
    await page.keyboard.press('1');
    await page.keyboard.press('f');
  });
});

test('a range of colours can be locked and mistyped', async () => {
  const view = page.locator('.viewport select.view').first();
  await change_picture(page, () => view.selectOption('thickness'));
  const low = page.locator('.viewport .bound').first(),
    high = page.locator('.viewport .bound').nth(1);
  await page.waitForFunction(() => document.querySelector('.viewport .bound').value !== '');
  const own = await read_picture(page);
  await change_picture(page, async () => {
    await low.fill('0.5');
    await high.fill('1.5');
    await high.press('Enter');
  });
  assert.notEqual((await read_picture(page)).sum, own.sum);
  await high.fill('0.1');
  await high.press('Enter');
  assert.equal(await high.getAttribute('aria-invalid'), 'true');
  await change_picture(page, () => page.locator('.range button').first().click());
  assert.equal((await read_picture(page)).sum, own.sum, 'unlocked, the range is the own one again');
  await change_picture(page, () => view.selectOption('contact-map'));
});

test('two views share the camera', async () => {
  await page.click('#two');
  await wait_picture(page, 'b');
  const before = [await read_picture(page, 'a'), await read_picture(page, 'b')];
  assert.notEqual(before[0].sum, before[1].sum);
  const camera = (slot) =>
    new URL(
      page.asked.filter((one) => one.includes('/api/frame') && one.includes(`slot=${slot}&`)).at(-1)
    ).searchParams.get('az');
  await change_picture(page, () => change_picture(page, () => page.keyboard.press('2'), 'b'), 'a');
  assert.equal(camera('a'), '90');
  assert.equal(camera('b'), '90');
  await page.keyboard.press('1');
  await change_picture(page, () => page.locator('.viewport select.view').nth(1).selectOption('slip'), 'b');
  const usual = await read_picture(page, 'b');
  await page.click('#arrows');
  await change_picture(page, () => page.locator('#slider-scale').fill('2'), 'b');
  const longer = await read_picture(page, 'b');
  assert.notEqual(longer.sum, usual.sum, 'arrows are as long as before');
  await change_picture(page, () => page.locator('#slider-density').fill('0.25'), 'b');
  assert.notEqual((await read_picture(page, 'b')).sum, longer.sum, 'there are as many arrows as before');
  await page.locator('#slider-scale').fill('1');
  await page.locator('#slider-density').fill('1');
  await page.keyboard.press('Escape');
  await page.click('#tab-charts');
  await page.waitForTimeout(1500);
  await wait_picture(page, 'b');
  await screenshot(page, '11-two-views');
  await page.click('#tab-inspect');
  await change_picture(page, () => page.click('#two'));
});

test('the timeline is scrubbed, also while the solver goes on, and live again', async () => {
  const box = await page.locator('#track').boundingBox();
  const {end_time_s} = await program.status();
  const x_of = (time) => box.x + 14 + ((box.width - 28) * time) / end_time_s;
  const goal = kept[Math.floor(kept.length / 2)];
  await change_picture(page, () => page.mouse.click(x_of(goal.time_s), box.y + 22));
  assert.match(await text_of(page, '#where'), new RegExp(`^increment ${goal.increment},`));
  await wait_picture(page, 'a', goal.increment);
  await page.mouse.move(x_of(goal.time_s), box.y + 22);
  await page.mouse.down();
  await page.mouse.move(x_of(kept[2].time_s), box.y + 22, {steps: 8});
  await page.mouse.up();
  await wait_picture(page, 'a', kept[2].increment);
  await type_command(page, 'set increment.largest 0.0005');
  await type_command(page, 'run');
  await program.wait_status((one) => one.phase === 'running', 'running');
  await page.locator('#track').focus();
  await page.keyboard.press('Home');
  await wait_picture(page, 'a', kept[0].increment);
  assert.equal((await program.status()).phase, 'running', 'looking back must not stop the run');
  await screenshot(page, '12-scrub');
  await page.click('#live');
  await type_command(page, 'pause');
  await wait_picture(page, 'a', (await program.wait_status((one) => one.phase === 'paused', 'paused')).increment);
  assert.equal(await page.locator('#live').getAttribute('aria-pressed'), 'true');
});

function png_size(file) {
  const bytes = fs.readFileSync(file);
  assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
}

test('a picture and a film are downloaded', async () => {
  const [picture] = await Promise.all([page.waitForEvent('download'), page.click('#png-a')]);
  const [width, height] = png_size(await picture.path());
  const at = await middle();
  assert.equal(width, 1920);
  assert.ok(Math.abs(height - (1920 * at.height) / at.width) < 2.5, `${width} x ${height}`);
  const [film] = await Promise.all([page.waitForEvent('download'), page.click('#film-a')]);
  const bytes = fs.readFileSync(await film.path());
  assert.equal(bytes.subarray(0, 4).toString() + bytes.subarray(8, 12).toString(), 'RIFFWEBP');
  assert.ok(bytes.includes('ANMF'), 'one picture only');
});

test('dark as the system is, and by the button', async (t) => {
  const light = await read_picture(page);
  await change_picture(page, () => page.click('#theme'));
  assert.ok((await read_picture(page)).light < 0.6 * light.light, 'the picture is as light as before');
  const back = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  assert.ok(
    back.match(/\d+/g).every((one) => Number(one) < 60),
    back
  );
  await page.waitForTimeout(500);
  await screenshot(page, '13-dark');
  await change_picture(page, () => page.click('#theme'));
  const other = await open_page(program, {colorScheme: 'dark'});
  t.after(() => other.context().close());
  assert.equal(await other.evaluate(() => document.documentElement.dataset.theme), 'dark');
});

test('everything by keys, and no way in without a way out', async (t) => {
  const own = await Program.start('keys');
  t.after(() => own.stop());
  const keys = await open_page(own);
  t.after(() => keys.context().close());
  const press = (key) => keys.keyboard.press(key);
  await press('s');
  await own.wait_status((one) => one.increment === 1 && one.phase === 'paused', 'a step');
  await wait_picture(keys, 'a', 1);
  const start = await read_picture(keys);
  await change_picture(keys, () => press('ArrowRight'));
  assert.notEqual((await read_picture(keys)).sum, start.sum);
  await change_picture(keys, () => press('+'));
  await change_picture(keys, async () => {
    await press('-');
    await press('1');
    await press('f');
  });
  assert.equal((await read_picture(keys)).sum, start.sum);
  await press('/');
  await keys.keyboard.type('until pressure 6');
  await press('Enter');
  await own.wait_status((one) => one.pressure_MPa > 5.9 && one.phase === 'paused', '6 MPa');
  await press('Escape');
  await wait_phase(keys, 'paused');
  const {increment} = await own.status();
  await press('Space');
  await own.wait_status((one) => one.increment > increment, 'running by the space bar');
  await wait_phase(keys, 'running');
  await press('Space');
  await own.wait_status((one) => one.phase === 'paused', 'paused by the space bar');
  await wait_phase(keys, 'paused');
  await press('[');
  await keys.waitForFunction(() => document.getElementById('live').getAttribute('aria-pressed') === 'false');
  await press('l');
  await keys.waitForFunction(() => document.getElementById('live').getAttribute('aria-pressed') === 'true');
  await press('?');
  await keys.locator('dialog.help').waitFor();
  await screenshot(keys, '14-help');
  await press('Escape');
  await keys.locator('dialog.help').waitFor({state: 'detached'});
  await press('t');
  assert.equal(await keys.evaluate(() => document.documentElement.dataset.theme), 'dark');
  const visited = await walk_by_tab(keys);
  for (const id of ['run', 'until', 'two', 'surface-a', 'track', 'splitter', 'tab-log', 'console'])
    assert.ok(visited.has(id), `Tab does not reach ${id}: ${[...visited]}`);
});

/// Ids that Tab comes by until it is where it began.
async function walk_by_tab(keys) {
  await keys.focus('#run');
  const visited = new Set(['run']);
  for (let i = 0; i < 150; ++i) {
    await keys.keyboard.press('Tab');
    const id = await keys.evaluate(() => document.activeElement?.id ?? '');
    if (id === 'run') return visited;
    visited.add(id);
  }
  throw new Error(`Tab is caught: ${[...visited]}`);
}
