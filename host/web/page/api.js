// SPDX-License-Identifier: Apache-2.0
// Requests to the server, its events, and what is shown when it does not answer.
'use strict';
const byId = id => document.getElementById(id);
let key = sessionStorage.getItem('key') || '';
const keyHeader = () => key ? {'X-Api-Key': key} : {};

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'onclick') made.addEventListener('click', value);
    else if (name in made && name !== 'list') made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

let messageTimer;
function show(text) {
  byId('message').textContent = text;
  byId('message').hidden = !text;
  clearTimeout(messageTimer);
  if (text) messageTimer = setTimeout(() => show(''), 10000);
}

function askForKey() { byId('key-form').hidden = false; byId('key').focus(); }

async function request(method, path, body) {
  try {
    const answer = await fetch(path, {method, headers: keyHeader(), body: body && JSON.stringify(body)});
    if (!answer.ok) {
      const text = await answer.text();
      let why = text;
      try { why = JSON.parse(text).error; } catch { /* it is no JSON */ }
      show(why || `refused (${answer.status})`);
    }
    return answer.ok;
  } catch {
    show('The server does not answer. Printing goes on; try again when it is there.');
    return false;
  }
}
const post = (path, body) => request('POST', path, body);

// State that is older than this is shown as old.
const oldAfterMs = 6000;
let heardAt = 0;
function markAge() {
  const old = Date.now() - heardAt > oldAfterMs;
  if (document.body.classList.contains('old') === old && heardAt) return;
  document.body.classList.toggle('old', old);
  byId('connection').textContent = !old ? 'live' : heardAt
    ? `no connection since ${new Date(heardAt).toLocaleTimeString()}: what you see is old` : 'connecting …';
}
setInterval(markAge, 500);

function hear(block, onState) {
  let event = '', data = '';
  for (const line of block.split('\n')) {
    if (line.startsWith('event: ')) event = line.slice(7);
    if (line.startsWith('data: ')) data += line.slice(6);
  }
  heardAt = Date.now();
  markAge();
  if (event === 'state') onState(JSON.parse(data));
}

const sleep = ms => new Promise(done => setTimeout(done, ms));

// Reads the events, again after each end; a stream that is silent for long is given up.
async function listen(onState) {
  for (;;) {
    const given = new AbortController();
    const watch = setInterval(() => { if (Date.now() - begun > 8000 && Date.now() - heardAt > 8000) given.abort(); }, 1000);
    const begun = Date.now();
    try {
      const answer = await fetch('/api/v1/events', {headers: keyHeader(), signal: given.signal});
      if (answer.status === 403) askForKey();
      if (answer.ok) {
        byId('key-form').hidden = true;
        const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
        let text = '';
        for (let part; !(part = await reader.read()).done;) {
          text += part.value;
          const blocks = text.split('\n\n');
          text = blocks.pop();
          blocks.forEach(block => hear(block, onState));
        }
      }
    } catch { /* again */ }
    clearInterval(watch);
    await sleep(1000);
  }
}

byId('key-form').addEventListener('submit', event => {
  event.preventDefault();
  key = byId('key').value;
  sessionStorage.setItem('key', key);
  byId('key-form').hidden = true;
});
