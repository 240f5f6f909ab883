// SPDX-License-Identifier: GPL-3.0-or-later
// What stands over everything: a lost connection, a refused token.
import {next_attempt, retry_now} from './connection.js';
import {button, el, replace} from './dom.js';
import {store} from './store.js';

export function build_notice(root) {
  const draw = (connection) => {
    root.hidden = connection !== 'lost' && connection !== 'refused';
    root.className = connection;
    root.setAttribute('role', 'alert');
    if (connection === 'lost')
      replace(
        root,
        el('span', {}, 'The connection to the program is lost; trying again. The run itself does not need this page.'),
        button({text: 'Try now', title: 'Try to connect now', kind: 'small'}, retry_now)
      );
    if (connection === 'refused')
      replace(
        root,
        el(
          'div',
          {},
          el('h2', {}, 'This page is no longer let in'),
          el(
            'p',
            {},
            'The program was started again, or its token has gone. Open the address that ',
            el('code', {}, 'hydroscope serve'),
            ' printed last; it looks like ',
            el('code', {}, 'http://127.0.0.1:PORT/?token=…'),
            '. The run goes on without this page.'
          )
        )
      );
    document.documentElement.dataset.connection = connection;
    if (connection === 'lost') document.title = `(no connection, attempt ${next_attempt() + 1}) Hydroscope`;
  };
  store.on('connection', draw);
  draw(store.get('connection'));
}
