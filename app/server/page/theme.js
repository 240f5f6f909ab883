// SPDX-License-Identifier: GPL-3.0-or-later
// Light or dark: as the system says until the user says otherwise. Pictures follow.
import {store} from './store.js';

const dark = window.matchMedia('(prefers-color-scheme: dark)');

export function start_theme() {
  dark.addEventListener('change', () => {
    if (!localStorage.getItem('theme')) apply(dark.matches ? 'dark' : 'light');
  });
  apply(localStorage.getItem('theme') ?? (dark.matches ? 'dark' : 'light'));
}

export function toggle_theme() {
  const theme = store.get('theme') === 'dark' ? 'light' : 'dark';
  localStorage.setItem('theme', theme);
  apply(theme);
}

function apply(theme) {
  document.documentElement.dataset.theme = theme;
  store.set('theme', theme);
}

/// A colour of the style sheet, for canvases.
export function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
