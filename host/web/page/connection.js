// SPDX-License-Identifier: Apache-2.0
// Requests to the server, its events, and what is shown when it does not answer.
let key = sessionStorage.getItem('key') || '';
const keyHeader = () => key ? {'X-Api-Key': key} : {};

function askForKey() {
  if (!byId('key-form').hidden) return;
  byId('key-form').hidden = false;
  byId('key').focus();
}
byId('key-form').addEventListener('submit', event => {
  event.preventDefault();
  key = byId('key').value;
  sessionStorage.setItem('key', key);
  byId('key-form').hidden = true;
});

// Why the server refused, in its own words.
async function reasonOf(answer) {
  const text = await answer.text();
  try { return JSON.parse(text).error; } catch { return text || `refused (${answer.status})`; }
}

// Nothing where it was done; else why not.
async function refusal(method, path, body) {
  try {
    const answer = await fetch(path, {method, headers: keyHeader(), body: body && JSON.stringify(body)});
    if (answer.status === 403) askForKey();
    return answer.ok ? '' : await reasonOf(answer);
  } catch {
    return 'The server does not answer. A print goes on without it; try again when it is there.';
  }
}

// True where it was done; shows why not.
async function request(method, path, body) {
  const why = await refusal(method, path, body);
  show(why);
  return !why;
}
const post = (path, body) => request('POST', path, body);

// Null where there is none, or no answer.
async function fetched(path, kind) {
  try {
    const answer = await fetch(path, {headers: keyHeader()});
    return answer.ok ? await answer[kind]() : null;
  } catch {
    return null;
  }
}

// State that is older than this is shown as old.
const oldAfterMs = 6000;
let heardAt = 0, refusedWhy = '', isConnected = false, progressWords = '';
function isOld() { return !isConnected || Date.now() - heardAt > oldAfterMs; }
function markAge() {
  const old = isOld();
  document.body.classList.toggle('old', old);
  const words = !old ? 'live' : heardAt
    ? `No connection since ${clockTime(heardAt)}: what you see is from then. The page connects again by itself.`
    : `connecting … ${refusedWhy}`;
  setText(byId('connection'), words);
  const title = `${old ? 'not connected – ' : progressWords}StepFabric printers`;
  if (document.title !== title) document.title = title;
}
setInterval(markAge, 500);

function hear(block, onState) {
  let event = '', data = '';
  for (const line of block.split('\n')) {
    if (line.startsWith('event: ')) event = line.slice(7);
    if (line.startsWith('data: ')) data += line.slice(6);
  }
  if (event !== 'state' && event !== 'alive') return;
  heardAt = Date.now();
  refusedWhy = '';
  if (event === 'state') {
    onState(JSON.parse(data));
    isConnected = true;
  }
  markAge();
}

const sleep = ms => new Promise(done => setTimeout(done, ms));
let listening = new AbortController();

// Reads the events, again after each end; a stream that is silent for long is given up. The first
// state of each stream is said to be so; between streams the page is old.
async function listen(onState) {
  for (;;) {
    listening = new AbortController();
    const begun = Date.now();
    const watch = setInterval(() => {
      if (Date.now() - begun > 8000 && Date.now() - heardAt > 8000) listening.abort();
    }, 1000);
    try {
      const answer = await fetch('/api/v1/events', {headers: keyHeader(), signal: listening.signal});
      if (answer.status === 403) askForKey();
      if (answer.ok) {
        byId('key-form').hidden = true;
        const reader = answer.body.pipeThrough(new TextDecoderStream()).getReader();
        let text = '', first = true;
        for (let part; !(part = await reader.read()).done;) {
          text += part.value;
          const blocks = text.split('\n\n');
          text = blocks.pop();
          for (const block of blocks) {
            hear(block, state => onState(state, first));
            first = false;
          }
        }
      } else {
        refusedWhy = await reasonOf(answer);
      }
    } catch { /* again */ }
    clearInterval(watch);
    const wasConnected = isConnected;
    isConnected = false;
    markAge();
    await sleep(wasConnected ? 200 : 1000);
  }
}

// A page that was asleep, or comes back from the history, has old state and perhaps a dead stream.
function wake() {
  if (document.visibilityState !== 'visible') return;
  markAge();
  if (heardAt && isOld()) listening.abort();
}
document.addEventListener('visibilitychange', wake);
addEventListener('pageshow', wake);
addEventListener('online', () => { if (isOld()) listening.abort(); });
