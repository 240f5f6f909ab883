// SPDX-License-Identifier: GPL-3.0-or-later
// The real program, started for a test and ended after it.
import {spawn} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const kPatience = 60000; // [ms]; a limit for what hangs, not a measure

export const options = {program: '', output: '', folder: path.dirname(new URL(import.meta.url).pathname)};

export class Program {
  #lines = '';
  #child;
  #ended;

  /// `hydroscope serve SUBJECT ...`; waits for the address. The results lie in `this.results`.
  static async start(name, {subject = path.join(options.folder, 'scene.toml'), set = {}, more = []} = {}) {
    const program = new Program();
    program.results = path.join(options.output, name);
    const is_folder = fs.statSync(subject).isDirectory();
    if (is_folder) program.results = subject;
    const overrides = Object.entries(set).flatMap(([key, value]) => ['--set', `${key}=${value}`]);
    const output = is_folder ? [] : ['-o', program.results, '--force'];
    await program.#launch(['serve', subject, '--port', '0', ...output, ...overrides, ...more]);
    return program;
  }

  async #launch(words) {
    this.#child = spawn(options.program, words, {stdio: ['ignore', 'pipe', 'pipe']});
    this.#ended = new Promise((resolve) => this.#child.on('exit', (code, signal) => resolve(code ?? signal)));
    const found = new Promise((resolve, reject) => {
      const listen = (chunk) => {
        this.#lines += chunk;
        const match = this.#lines.match(/Open (http:\/\/\S+)/);
        if (match) resolve(match[1]);
      };
      this.#child.stdout.on('data', listen);
      this.#child.stderr.on('data', listen);
      this.#child.on('error', reject);
      this.#ended.then((code) =>
        reject(new Error(`the program ended (${code}) before it printed an address:\n${this.#lines}`))
      );
      setTimeout(() => reject(new Error(`no address within a minute:\n${this.#lines}`)), kPatience).unref();
    });
    this.url = await found;
    this.origin = new URL(this.url).origin;
    this.token = new URL(this.url).searchParams.get('token');
  }

  /// JSON of the API, asked for as a script would.
  async get(address) {
    const answer = await fetch(this.origin + address, {headers: {Authorization: `Bearer ${this.token}`}});
    if (!answer.ok) throw new Error(`${address}: ${answer.status} ${await answer.text()}`);
    return answer.json();
  }

  status() {
    return this.get('/api/status?viewer=test');
  }

  /// Asks until `is_met(status)`.
  async wait_status(is_met, what) {
    const end = Date.now() + kPatience;
    for (;;) {
      const status = await this.status();
      if (is_met(status)) return status;
      if (Date.now() > end) throw new Error(`never: ${what}; last status ${JSON.stringify(status)}`);
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
  }

  /// Ctrl-C; the exit code.
  async stop(signal = 'SIGINT') {
    if (this.#child.exitCode === null && this.#child.signalCode === null) this.#child.kill(signal);
    const killer = setTimeout(() => this.#child.kill('SIGKILL'), kPatience);
    const code = await this.#ended;
    clearTimeout(killer);
    return code;
  }

  text() {
    return this.#lines;
  }

  /// Rows of a table of the result folder, as words by the names of their columns.
  table(file) {
    const [head, ...rows] = fs.readFileSync(path.join(this.results, file), 'utf8').trim().split('\n');
    const names = head.split(',');
    return rows.map((row) => Object.fromEntries(row.split(',').map((word, i) => [names[i], word])));
  }

  journal() {
    const file = path.join(this.results, 'journal.jsonl');
    return fs.existsSync(file)
      ? fs
          .readFileSync(file, 'utf8')
          .trim()
          .split('\n')
          .filter(Boolean)
          .map((line) => JSON.parse(line))
      : [];
  }
}
