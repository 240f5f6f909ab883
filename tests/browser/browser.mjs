// SPDX-License-Identifier: GPL-3.0-or-later
// Headless Chromium, and what the tests want to know of the page.
import fs from 'node:fs';
import path from 'node:path';
import {options} from './program.mjs';

export const kPatience = 45000; // [ms]; a limit for what hangs, not a measure
const kPlaces = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];

export function find_chromium() {
  return kPlaces.find((place) => place && fs.existsSync(place));
}

let chromium = null,
  browser = null;

export async function open_browser() {
  if (browser?.isConnected()) return browser;
  chromium ??= (await import('playwright-core')).chromium;
  // Containers often run as root and without a large /dev/shm.
  browser = await chromium.launch({
    executablePath: find_chromium(),
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--disable-gpu']
  });
  return browser;
}

export async function close_browser() {
  await browser?.close();
  browser = null;
}

/// A viewer of its own: page with lists of what went wrong and what was asked for.
export async function open_viewer({width = 1366, height = 768, ...more} = {}) {
  const context = await (await open_browser()).newContext({viewport: {width, height}, acceptDownloads: true, ...more});
  context.setDefaultTimeout(kPatience);
  const page = await context.newPage();
  page.faults = [];
  page.asked = [];
  page.on('pageerror', (error) => page.faults.push(String(error)));
  page.on('console', (message) => {
    if (/Content Security|Uncaught|TypeError/.test(message.text())) page.faults.push(message.text());
  });
  page.on('request', (request) => page.asked.push(request.url()));
  return page;
}

/// Opened at the program's address, with a full picture.
export async function open_page(program, more = {}) {
  const page = await open_viewer(more);
  await page.goto(program.url);
  await wait_picture(page);
  return page;
}

/// Waits until the picture at rest shows what is wished: no movement, full quality.
export async function wait_picture(page, slot = 'a', increment = null) {
  await page.waitForFunction(
    ([slot, increment]) => {
      const {kind, increment: shown} = document.getElementById(`surface-${slot}`)?.dataset ?? {};
      return kind === 'rest' && (increment === null || Number(shown) === increment);
    },
    [slot, increment]
  );
}

/// Does something that changes the picture and waits for the full one.
export async function change_picture(page, act, slot = 'a') {
  const count = () =>
    page.evaluate((slot) => Number(document.getElementById(`surface-${slot}`).dataset.frames || 0), slot);
  const before = await count();
  await act();
  await page.waitForFunction(
    ([slot, before]) => {
      const {kind, frames} = document.getElementById(`surface-${slot}`).dataset;
      return kind === 'rest' && Number(frames) > before;
    },
    [slot, before]
  );
}

/// Of the picture as it is shown: a check sum, the number of colours, the mean brightness 0..255.
export function read_picture(page, slot = 'a') {
  return page.evaluate((slot) => {
    const canvas = document.querySelector(`#surface-${slot} canvas`);
    const {data} = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    let sum = 2166136261,
      light = 0;
    for (let i = 0; i < data.length; i += 4) {
      const rgb = (data[i] << 16) | (data[i + 1] << 8) | data[i + 2];
      colours.add(rgb);
      light += (data[i] + data[i + 1] + data[i + 2]) / 3;
      sum = Math.imul(sum ^ rgb, 16777619) >>> 0;
    }
    return {sum, colours: colours.size, light: light / (data.length / 4), width: canvas.width, height: canvas.height};
  }, slot);
}

export const text_of = (page, selector) => page.locator(selector).innerText();

export function wait_text(page, selector, pattern) {
  return page.waitForFunction(
    ([selector, source]) => new RegExp(source).test(document.querySelector(selector)?.textContent ?? ''),
    [selector, pattern.source]
  );
}

export async function screenshot(page, name) {
  const folder = path.join(options.output, 'screenshots');
  fs.mkdirSync(folder, {recursive: true});
  await page.screenshot({path: path.join(folder, `${name}.png`)});
}

/// Sends a command by the console line of the page and returns its reply as shown.
export async function type_command(page, text) {
  if (await page.locator('#panel-log').isHidden()) await page.click('#tab-log');
  const count = await page.locator('#replies li:not(.hint)').count();
  await page.fill('#console', text);
  await page.press('#console', 'Enter');
  await page.waitForFunction((count) => document.querySelectorAll('#replies li:not(.hint)').length > count, count);
  return page.locator('#replies li').last().innerText();
}

export const wait_phase = (page, phase) =>
  page.waitForFunction((phase) => document.getElementById('phase').dataset.phase === phase, phase);
