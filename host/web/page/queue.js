// SPDX-License-Identifier: Apache-2.0
// Jobs that wait, jobs that are over, and uploads.
const isOver = job => ['finished', 'cancelled', 'failed', 'refused'].includes(job.state);
const isActive = job => ['starting', 'printing', 'paused'].includes(job.state);
let dragged = null, shownJobs = '';

function jobButton(job, text, action) {
  return element('button', {type: 'button', 'data-key': `${job.id} ${text}`, ariaLabel: `${text}: ${job.name}`, onclick: action}, text);
}

function describe(job) {
  const parts = [job.held && !isOver(job) ? 'held' : job.state];
  if (job.printer) parts.push(`on ${job.printer}`);
  else if (job.wanted_printer) parts.push(`for ${job.wanted_printer}`);
  if (job.seconds) parts.push(`${time(job.seconds)}, ${(job.filament_mm / 1000).toFixed(2)} m filament`);
  if (job.reason) parts.push(job.reason);
  return parts.join(' · ');
}

function row(job, waiting) {
  const path = `/api/v1/jobs/${job.id}`;
  const place = waiting.indexOf(job);
  const buttons = element('div', {className: 'buttons'});
  if (place > 0) buttons.append(jobButton(job, '↑', () => post(path + '/move', {before: waiting[place - 1].id})));
  if (place >= 0 && place + 1 < waiting.length) {
    const after = waiting[place + 2];
    buttons.append(jobButton(job, '↓', () => post(path + '/move', {before: after ? after.id : null})));
  }
  if (job.state === 'interrupted') buttons.append(jobButton(job, 'Print again', () => post(path + '/again')));
  if (job.held && place >= 0) buttons.append(jobButton(job, 'Release', () => post(path + '/hold', {held: false})));
  if (!isOver(job)) buttons.append(jobButton(job, job.state === 'interrupted' ? 'Give up' : 'Cancel', () => post(path + '/cancel')));
  if (isOver(job) && job.state !== 'refused') buttons.append(jobButton(job, 'Print again', () => post(path + '/again')));
  if (isOver(job)) buttons.append(jobButton(job, 'Remove', () => request('DELETE', path)));
  const item = element('li', {draggable: place >= 0},
    element('span', {className: 'name'}, job.name), element('span', {className: 'what'}, describe(job)), buttons);
  if (place < 0) return item;
  item.addEventListener('dragstart', event => { dragged = job.id; event.dataTransfer.setData('text/plain', String(job.id)); });
  item.addEventListener('dragend', () => { dragged = null; });
  item.addEventListener('dragover', event => { if (dragged !== null) { event.preventDefault(); item.classList.add('target'); } });
  item.addEventListener('dragleave', () => item.classList.remove('target'));
  item.addEventListener('drop', event => {
    if (dragged === null) return;
    event.preventDefault();
    event.stopPropagation();
    item.classList.remove('target');
    if (dragged !== job.id) post(`/api/v1/jobs/${dragged}/move`, {before: job.id});
  });
  return item;
}

function showJobs(jobs) {
  const text = JSON.stringify(jobs);
  if (text === shownJobs || dragged !== null) return;
  shownJobs = text;
  const focused = document.activeElement && document.activeElement.getAttribute('data-key');
  const waiting = jobs.filter(job => !isOver(job) && !isActive(job));
  const open = [...jobs.filter(isActive), ...waiting];
  byId('queue').replaceChildren(...open.map(job => row(job, waiting)));
  byId('over').replaceChildren(...jobs.filter(isOver).sort((a, b) => b.changed_ms - a.changed_ms).map(job => row(job, waiting)));
  byId('empty').hidden = open.length > 0;
  if (focused) document.querySelector(`[data-key="${CSS.escape(focused)}"]`)?.focus();
}

// XMLHttpRequest, because fetch tells no progress of an upload.
function upload(file) {
  return new Promise(done => {
    const form = new FormData();
    form.append('print', String(!byId('held').checked));
    form.append('file', file);
    const sending = new XMLHttpRequest();
    const wanted = byId('wanted').value;
    sending.open('POST', '/api/v1/jobs' + (wanted ? `?printer=${encodeURIComponent(wanted)}` : ''));
    if (key) sending.setRequestHeader('X-Api-Key', key);
    sending.upload.onprogress = event => { byId('upload').value = event.loaded / Math.max(1, event.total); };
    sending.onloadend = () => {
      if (sending.status !== 201) {
        let why = 'the server does not answer';
        try { why = JSON.parse(sending.responseText).error; } catch { /* it is no JSON */ }
        show(`${file.name} was not taken: ${why}`);
      }
      done();
    };
    sending.send(form);
  });
}

async function uploadAll(files) {
  byId('upload').hidden = false;
  for (const file of files) await upload(file);
  byId('upload').hidden = true;
}

byId('files').addEventListener('change', async event => { await uploadAll([...event.target.files]); event.target.value = ''; });
const drop = byId('drop');
addEventListener('dragover', event => { event.preventDefault(); if (dragged === null) drop.classList.add('over'); });
addEventListener('dragleave', () => drop.classList.remove('over'));
addEventListener('drop', event => {
  event.preventDefault();
  drop.classList.remove('over');
  if (event.dataTransfer.files.length) uploadAll([...event.dataTransfer.files]);
});

function showWanted(printers) {
  const select = byId('wanted');
  if (select.options.length === printers.length + 1) return;
  printers.forEach(printer => select.append(element('option', {value: printer.name}, printer.name)));
}

listen(state => {
  if (state.fault) show(`The spooler cannot go on: ${state.fault}`);
  state.printers.forEach(printer => showPrinter(printer, state.jobs));
  showWanted(state.printers);
  showJobs(state.jobs);
});
