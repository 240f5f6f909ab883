// SPDX-License-Identifier: GPL-3.0-or-later
// One picture slot: at most one request under way, the newest wish wins. Small pictures while something moves,
// full ones at rest, and new ones as the solver goes on.

const kRest = 160; // [ms] without movement until a full picture is asked for
const kRetry = 700;

export class FrameLoop {
  #flight = null; // {controller, kind}
  #is_dirty = true; // what is wished differs from what was last asked for
  #moved_at = -Infinity;
  #drawn = null; // {kind, branch, increment}
  #timer = null;

  /// fetch(kind, after, signal) -> frame or null; kind: drag | live | rest. draw(frame, kind). fail(error).
  /// live() -> {branch, increment, is_running} when the newest state is shown, else null. is_ready().
  constructor({fetch, draw, fail, live, is_ready}) {
    Object.assign(this, {fetch, draw, fail, live, is_ready});
  }

  /// Camera, view or state changed. `is_moving`: more changes are to be expected at once.
  change(is_moving = false) {
    this.#is_dirty = true;
    if (is_moving) this.#moved_at = performance.now();
    // A full picture on its way is in the way of a drag.
    if (this.#flight && this.#flight.kind !== 'drag') this.#flight.controller.abort();
    this.pump();
  }

  /// The run went on, the page came back into sight, the connection is there again.
  pump() {
    if (this.#flight || !this.is_ready()) return;
    const kind = this.#choose();
    if (kind) this.#start(kind);
  }

  #is_moving() {
    return performance.now() - this.#moved_at < kRest;
  }

  #choose() {
    if (this.#is_moving()) {
      this.#wake(kRest);
      return this.#is_dirty ? 'drag' : null;
    }
    const live = this.live();
    if (this.#is_dirty || !this.#drawn || this.#drawn.kind === 'drag') return live?.is_running ? 'live' : 'rest';
    if (live && (live.increment !== this.#drawn.increment || live.branch !== this.#drawn.branch))
      return live.is_running ? 'live' : 'rest';
    return this.#drawn.kind === 'live' && !live?.is_running ? 'rest' : null;
  }

  #wake(delay) {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.pump(), delay);
  }

  async #start(kind) {
    const live = this.live();
    // Only then does the program pace itself for those who merely watch.
    const is_watching =
      kind === 'live' &&
      !this.#is_dirty &&
      this.#drawn?.branch === live?.branch &&
      live.increment > this.#drawn.increment;
    const flight = {controller: new AbortController(), kind};
    this.#flight = flight;
    this.#is_dirty = false;
    let wait = null;
    try {
      const frame = await this.fetch(kind, is_watching ? this.#drawn.increment : null, flight.controller.signal);
      if (frame) {
        this.#drawn = {kind, branch: frame.branch, increment: frame.increment};
        this.draw(frame, kind);
      } else {
        wait = 100;
        if (!is_watching) this.#is_dirty = true;
      }
    } catch (error) {
      this.#is_dirty = true;
      if (error.name !== 'AbortError') {
        this.fail(error);
        wait = error.status === 400 ? null : kRetry;
        if (wait === null)
          ((this.#is_dirty = false), (this.#drawn = {kind: 'rest', branch: live?.branch, increment: live?.increment}));
      }
    }
    this.#flight = null;
    if (wait === null) this.pump();
    else this.#wake(wait);
  }
}
