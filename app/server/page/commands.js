// SPDX-License-Identifier: GPL-3.0-or-later
// One path for every act of steering: buttons, fields, keys and the console line all send the same text.
import {post} from './api.js';
import {store} from './store.js';

/// Never throws: {ok, text}. Whoever asked shows the text; the log keeps it too.
export async function send(text) {
  let reply;
  try {
    const answer = await post('/api/command', {}, text);
    reply = {ok: answer.done !== false, text: answer.text || 'done', increment: answer.increment};
  } catch (error) {
    reply = {ok: false, text: error.message, increment: store.get('status')?.increment};
  }
  store.set('log', [...store.get('log'), {command: text, ...reply, at: new Date()}]);
  return reply;
}

/// Takes or gives the wheel: {ok, text}.
export async function steer(take, force = false) {
  try {
    await post('/api/steer', {take: take ? '1' : '0', force});
    return {ok: true, text: take ? 'You have the wheel.' : 'The wheel is free.'};
  } catch (error) {
    return {ok: false, text: error.message, status: error.status};
  }
}

/// Whether commands from this page are heeded now.
export function may_steer() {
  const status = store.get('status');
  return Boolean(status && status.can_steer && status.you_steer && store.get('connection') === 'open');
}
