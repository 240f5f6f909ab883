// SPDX-License-Identifier: GPL-3.0-or-later
// Elements without a template language, and icons without files.

/// el('button', {class: 'x', onclick: f, 'aria-label': 'y'}, 'text', child): attributes whose value is false, null or
/// undefined are left out; functions are listeners.
export function el(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    if (typeof value === 'function') node.addEventListener(name.replace(/^on/, ''), value);
    else node.setAttribute(name, value === true ? '' : value);
  }
  node.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}

export function replace(node, ...children) {
  node.replaceChildren(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
  return node;
}

/// Changes the text only where it differs: screen readers and selections are left in peace.
export function set_text(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

const kIcons = {
  run: 'M4 2.5v11l9-5.5z',
  pause: 'M4 2.5h3v11H4zM9 2.5h3v11H9z',
  step: 'M3 2.5v11l7-5.5zM11 2.5h2v11h-2z',
  stop: 'M3 3h10v10H3z',
  until: 'M3 14V2h1.4v1H13l-2.2 3L13 9H4.4v5z',
  previous: 'M12 2.5v11L5 8zM3 2.5h1.6v11H3z',
  next: 'M4 2.5v11L11 8zM11.4 2.5H13v11h-1.6z',
  branch:
    'M5 1.5a2 2 0 0 1 .75 3.85v5.3a2 2 0 1 1-1.5 0v-5.3A2 2 0 0 1 5 1.5zm7 1.5a2 2 0 0 1 .75 3.85C12.6 9.3 10.6 10.2 7 10.5V9c2.700-.25 4.050-.8 4.250-2.150A2 2 0 0 1 12 3z',
  wheel:
    'M8 1a7 7 0 1 1 0 14A7 7 0 0 1 8 1zm0 1.500a5.500 5.500 0 0 0-5.400 4.500h2.700a2.800 2.800 0 0 1 5.400 0h2.700A5.500 5.500 0 0 0 8 2.500zm-.75 10.950v-2.750a2.800 2.800 0 0 1-1.950-2.200H2.550a5.500 5.500 0 0 0 4.700 4.950zm1.500 0a5.500 5.500 0 0 0 4.700-4.950H10.700a2.800 2.800 0 0 1-1.950 2.200z',
  theme: 'M8 1a7 7 0 1 1 0 14A7 7 0 0 1 8 1zm0 1.500v11a5.500 5.500 0 0 0 0-11z',
  lock: 'M4.500 7V5a3.500 3.500 0 0 1 7 0v2H13v7.500H3V7zM6 7h4V5a2 2 0 0 0-4 0z',
  fit: 'M2 2h4v1.500H3.500V6H2zm8 0h4v4h-1.500V3.500H10zM2 10h1.500v2.500H6V14H2zm10.500 0H14v4h-4v-1.500h2.500zM5.500 5.500h5v5h-5z',
  download:
    'M7.250 1.500h1.500v6.700l2.500-2.500 1.050 1.050L8 11.100 3.700 6.750 4.750 5.700l2.500 2.500zM2.500 12.500h11V14h-11z',
  close:
    'M3.500 2.400 8 6.900l4.500-4.500 1.100 1.100L9.100 8l4.500 4.500-1.100 1.100L8 9.100l-4.500 4.500-1.100-1.100L6.900 8 2.400 3.500z',
  flip: 'M7.300 1.500h1.400v13H7.300zM1.500 12.500 6 3.500v9zM10 3.500l4.500 9H10z'
};

export function icon(name) {
  const kSvg = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(kSvg, 'svg');
  const path = document.createElementNS(kSvg, 'path');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  path.setAttribute('d', kIcons[name]);
  path.setAttribute('fill-rule', 'evenodd');
  svg.append(path);
  return svg;
}

/// A button with an icon, a caption (perhaps empty) and what it does.
export function button(options, onclick) {
  const {icon: symbol, text, title, id, pressed, kind = '', key} = options;
  const node = el(
    'button',
    {
      type: 'button',
      id,
      class: kind,
      title: key ? `${title} (${key})` : title,
      'aria-label': text ? null : title,
      'aria-keyshortcuts': key,
      'aria-pressed': pressed === undefined ? null : String(pressed),
      onclick
    },
    symbol ? icon(symbol) : null,
    text ? el('span', {}, text) : null
  );
  return node;
}

/// A question with buttons; the answer is the chosen value, '' when it was waved away.
export function ask(title, text, answers) {
  return new Promise((resolve) => {
    const buttons = answers.map(([value, caption, kind]) => el('button', {value, class: kind || ''}, caption));
    const dialog = el(
      'dialog',
      {class: 'ask', 'aria-label': title},
      el('form', {method: 'dialog'}, el('h2', {}, title), el('p', {}, text), el('div', {class: 'row end'}, ...buttons))
    );
    dialog.addEventListener('close', () => {
      dialog.remove();
      resolve(dialog.returnValue);
    });
    document.body.append(dialog);
    dialog.showModal();
  });
}
