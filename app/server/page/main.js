// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together.
import {fly_to, kHome, turn_towards} from './camera.js';
import {build_change} from './change.js';
import {connect} from './connection.js';
import {follow_status, load_all} from './data.js';
import {replace} from './dom.js';
import {build_inspector, set_flight} from './inspector.js';
import {start_keyboard} from './keyboard.js';
import {build_ledger} from './ledger.js';
import {build_charts} from './live_charts.js';
import {build_log, focus_console} from './log.js';
import {build_notice} from './notice.js';
import {pick_point} from './picking.js';
import {attach_splitter, build_side} from './side.js';
import {store} from './store.js';
import {start_theme} from './theme.js';
import {build_timeline, go, go_live, show_time} from './timeline.js';
import {build_toolbar, kDisplay} from './toolbar.js';
import {build_topbar} from './topbar.js';
import {Viewport} from './viewport.js';
import {add_warning, build_warnings} from './warnings.js';

const find = (id) => document.getElementById(id);

store.set('camera', {...kHome});
store.set('display', {...kDisplay});
store.set('slots', {a: {view: 'contact-map', range: null}, b: {view: 'thickness', range: null}});
start_theme();

const viewports = {a: new Viewport('a'), b: new Viewport('b')};
replace(find('viewports'), viewports.a.root, viewports.b.root);
const show_two = (is_two) => {
  viewports.b.root.hidden = !is_two;
  find('viewports').classList.toggle('two', is_two);
  if (!is_two) store.set('active', 'a');
};
store.on('two_views', show_two);
show_two(false);

/// Looks at a place of the part from near; `size` [mm] of what is there; from the side of the tool that touches it.
function fly(place, size, tool_normal) {
  const [low, high] = store.get('model').box;
  const extent = Math.hypot(...high.map((value, i) => value - low[i]));
  const camera = fly_to(store.get('camera'), place, size, extent);
  store.set(
    'camera',
    tool_normal
      ? turn_towards(
          camera,
          tool_normal.map((value) => -value)
        )
      : camera
  );
}

build_notice(find('notice'));
build_topbar(find('topbar'));
build_toolbar(find('toolbar'));
build_timeline(find('timeline'));
const panels = build_side(find('side'));
attach_splitter(find('splitter'), find('desk'));
build_inspector(panels.inspect);
set_flight(fly);
build_ledger(panels.ledger, fly);
build_charts(panels.charts, show_time);
build_warnings(panels.warnings, find('toasts'));
build_change(panels.change);
build_log(panels.log);

start_keyboard({
  go,
  live: go_live,
  console: focus_console,
  pick_middle: () => {
    const viewport = viewports[store.get('active')];
    pick_point(viewport, viewport.surface.clientWidth / 2, viewport.surface.clientHeight / 2);
  }
});

follow_status();
const start = () => load_all().catch(() => {});
connect({warning: add_warning, contact: (event) => store.set('last_contact', event), recovered: start});
start();
