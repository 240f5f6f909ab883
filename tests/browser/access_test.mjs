// SPDX-License-Identifier: GPL-3.0-or-later
// Who is let in, and what the page asks for.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {open_page, open_viewer, read_picture, screenshot, text_of, wait_text} from './browser.mjs';
import {Program} from './program.mjs';

test('without the token, or with another, nothing is shown', async (t) => {
  const program = await Program.start('access');
  t.after(() => program.stop());
  const page = await open_viewer();
  t.after(() => page.context().close());
  for (const address of ['/', '/?token=0123456789abcdef', '/page/main.js', '/api/status?viewer=x']) {
    const answer = await page.goto(program.origin + address);
    assert.equal(answer.status(), 401, address);
    assert.equal(await page.locator('#run').count(), 0);
  }
  assert.match(await text_of(page, 'body'), /token|address|URL/i);
});

test('with the token the page loads, shows a picture, and asks nobody else', async (t) => {
  const program = await Program.start('load');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  assert.equal(new URL(page.url()).search, '', 'the token must not stay in the address');
  await wait_text(page, '#title', /Tube into a square die/);
  assert.match(await text_of(page, '#phase'), /Paused/);
  const picture = await read_picture(page);
  assert.ok(picture.colours > 200, `only ${picture.colours} colours: no shaded part`);
  const foreign = page.asked.filter((address) => new URL(address).origin !== program.origin);
  assert.deepEqual(foreign, []);
  assert.deepEqual(page.faults, []);
  const cookies = await page.context().cookies();
  assert.equal(cookies.length, 1);
  assert.ok(cookies[0].httpOnly && cookies[0].sameSite === 'Strict');
  await screenshot(page, '01-start');
});

test('when the token is no longer good the page says how to get in again', async (t) => {
  const program = await Program.start('gone');
  t.after(() => program.stop());
  const page = await open_page(program);
  t.after(() => page.context().close());
  await page.context().clearCookies();
  await page.click('#step');
  await wait_text(page, '#notice', /no longer let in/);
  assert.match(await text_of(page, '#notice'), /hydroscope serve/);
  await screenshot(page, '02-refused');
});
