// SPDX-License-Identifier: GPL-3.0-or-later
// The workstation's page in a real browser against the real program.
//   node tests/browser/run.mjs --program build/release/hydroscope --output build/browser [--only NAME]
// NAME: access, steering, looking or inspecting. Screenshots come to OUTPUT/screenshots.
import fs from 'node:fs';
import path from 'node:path';
import {after} from 'node:test';

function give_up(text) {
  console.error(`browser tests: ${text}`);
  process.exit(1);
}

function read_option(name, standard) {
  const at = process.argv.indexOf(`--${name}`);
  return at > 0 ? process.argv[at + 1] : standard;
}

if (Number(process.versions.node.split('.')[0]) < 18)
  give_up(`node ${process.version} is too old; 18 or newer is needed (Debian: apt-get install nodejs)`);
await import('playwright-core').catch(() =>
  give_up(
    'playwright-core is missing; install it with: cd tests/browser && PLAYWRIGHT_SKIP_BROWSER_DOWNLOAD=1 npm ci   (sh tests/run.sh does so)'
  )
);

const {close_browser, find_chromium} = await import('./browser.mjs');
const {options} = await import('./program.mjs');
if (!find_chromium())
  give_up('no Chromium was found; install it with: apt-get install chromium   (or name one in the variable CHROMIUM)');
options.program = path.resolve(read_option('program', 'build/release/hydroscope'));
options.output = path.resolve(read_option('output', 'build/browser'));
if (!fs.existsSync(options.program))
  give_up(`there is no program ${options.program}; build it, or name it with --program`);
fs.mkdirSync(options.output, {recursive: true});

after(close_browser);
const only = read_option('only', '');
for (const name of ['access', 'steering', 'looking', 'inspecting'])
  if (!only || only === name) await import(`./${name}_test.mjs`);
