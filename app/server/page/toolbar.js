// SPDX-License-Identifier: GPL-3.0-or-later
// How things are shown: directions, cut, tools, lines, arrows, two pictures, downloads.
import {kHome, kStandardViews, look_from} from './camera.js';
import {button, el, icon, replace, set_text} from './dom.js';
import {store} from './store.js';

export const kDisplay = Object.freeze({
  clip: '',
  share: 0.5,
  flip: false,
  opacity: 0.35,
  mirror: true,
  edges: false,
  features: true,
  density: 1,
  scale: 1
});

export function build_toolbar(root) {
  replace(
    root,
    make_directions(),
    make_cut(),
    make_tools(),
    make_lines(),
    make_arrows(),
    el('span', {class: 'grow'}),
    make_two()
  );
}

export function set_direction(view) {
  store.set('camera', look_from(store.get('camera'), view));
}
export function fit() {
  store.set('camera', {...store.get('camera'), zoom: kHome.zoom, px: 0, py: 0, focus: null});
}

function make_directions() {
  const buttons = kStandardViews.map((view) =>
    button(
      {
        text: view.name,
        title: view.from ? `Look from ${view.from}` : 'Look from an edge',
        key: view.key,
        kind: 'joined'
      },
      () => set_direction(view)
    )
  );
  return el(
    'div',
    {class: 'group', role: 'group', 'aria-label': 'Standard views'},
    buttons,
    button({icon: 'fit', title: 'Fit the whole part', key: 'F', id: 'fit', kind: 'joined'}, fit)
  );
}

const change = (fields) => store.patch('display', fields);

function make_slider(caption, name, options) {
  const value = el('output', {class: 'value'});
  const slider = el('input', {
    type: 'range',
    id: `slider-${name}`,
    'aria-label': options.label,
    title: options.label,
    ...options.bounds,
    oninput: () => change({[name]: Number(slider.value)})
  });
  const update = () => {
    slider.value = store.get('display')[name];
    set_text(value, options.text(store.get('display')[name]));
    slider.setAttribute('aria-valuetext', value.textContent);
  };
  store.on('display', update);
  update();
  return el('label', {class: 'slider'}, el('span', {}, caption), slider, value);
}

function make_toggle(caption, name, title) {
  const node = button(
    {text: caption, title, pressed: store.get('display')[name], kind: 'joined', id: `toggle-${name}`},
    () => change({[name]: !store.get('display')[name]})
  );
  store.on('display', (display) => node.setAttribute('aria-pressed', String(display[name])));
  return node;
}

const percent = (share) => `${Math.round(100 * share)} %`;

function make_cut() {
  const axis = el(
    'select',
    {
      id: 'clip',
      'aria-label': 'Cut across',
      title: 'Cut the part and the tools open',
      onchange: () => change({clip: axis.value})
    },
    el('option', {value: ''}, 'No cut'),
    ['x', 'y', 'z'].map((name) => el('option', {value: name}, `Cut ${name}`))
  );
  const place = make_slider('', 'share', {
    label: 'Where the cut is',
    bounds: {min: 0, max: 1, step: 0.005},
    text: percent
  });
  const flip = make_toggle('', 'flip', 'Keep the other side of the cut');
  flip.append(icon('flip'));
  flip.classList.replace('joined', 'small');
  const update = () => {
    const {clip} = store.get('display');
    axis.value = clip;
    place.hidden = flip.hidden = !clip;
  };
  store.on('display', update);
  update();
  return el('div', {class: 'group', role: 'group', 'aria-label': 'Cut'}, axis, place, flip);
}

function make_tools() {
  return make_slider('Tools', 'opacity', {
    label: 'How opaque tools are; 0: not drawn',
    bounds: {min: 0, max: 1, step: 0.05},
    text: percent
  });
}

function make_lines() {
  return el(
    'div',
    {class: 'group', role: 'group', 'aria-label': 'Lines'},
    make_toggle('Whole', 'mirror', 'Mirror the modelled part to the whole one'),
    make_toggle('Mesh', 'edges', 'Edges of the elements, deformed'),
    make_toggle('Edges', 'features', 'Sharp edges of the tools')
  );
}

function make_arrows() {
  const factor = (value) => `× ${value.toFixed(2).replace(/\.?0+$/, '')}`;
  const panel = el(
    'div',
    {class: 'popover', id: 'arrows-panel', role: 'group', 'aria-label': 'Arrows', hidden: true},
    make_slider('Number', 'density', {label: 'How many arrows', bounds: {min: 0, max: 4, step: 0.25}, text: factor}),
    make_slider('Length', 'scale', {
      label: 'How long arrows are',
      bounds: {min: 0.25, max: 4, step: 0.25},
      text: factor
    })
  );
  const opener = button({text: 'Arrows…', title: 'How many and how long arrows are', id: 'arrows'}, () =>
    show(panel.hidden)
  );
  const root = el('div', {class: 'anchor'}, opener, panel);
  const show = (is_open) => {
    panel.hidden = !is_open;
    opener.setAttribute('aria-expanded', String(is_open));
  };
  show(false);
  root.addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && !panel.hidden) {
      event.stopPropagation();
      show(false);
      opener.focus();
    }
  });
  document.addEventListener('pointerdown', (event) => {
    if (!root.contains(event.target)) show(false);
  });
  return root;
}

function make_two() {
  const two = button(
    {text: 'Two views', title: 'A second picture beside it, with the same camera', pressed: false, id: 'two'},
    () => store.set('two_views', !store.get('two_views'))
  );
  store.on('two_views', (is_on) => two.setAttribute('aria-pressed', String(is_on)));
  return two;
}
