// SPDX-License-Identifier: Apache-2.0
// Jobs that wait, jobs that are over.
const isOver = job => ['finished', 'cancelled', 'failed', 'refused'].includes(job.state);
const isActive = job => ['starting', 'printing', 'paused'].includes(job.state);
let jobs = [];
const waitingJobs = () => jobs.filter(job => !isOver(job) && !isActive(job));
const rows = new Map();  // by job: {text, item}
const pictures = new Map();

// Of its own, where several have the same.
const nameOf = job => jobs.some(each => each.id !== job.id && each.name === job.name) ? `${job.name} (job ${job.id})` : job.name;

function jobButton(job, text, action, name = text) {
  return element('button', {type: 'button', 'data-key': `${job.id} ${text}`, 'aria-label': `${name}: ${nameOf(job)}`,
    onclick: action}, text);
}

function describe(job) {
  const parts = [job.held && !isOver(job) ? 'held' : job.state];
  if (job.printer) parts.push(`on ${job.printer}`);
  else if (job.wanted_printer) parts.push(`for ${job.wanted_printer}`);
  if (job.seconds) parts.push(`${duration(job.seconds)}, ${(job.filament_mm / 1000).toFixed(2)} m filament`);
  if (job.reason) parts.push(job.reason);
  if (isOver(job)) parts.push(new Date(job.changed_ms).toLocaleString());
  return parts.join(' · ');
}

function adviceFor(job) {
  if (job.state === 'refused') return 'Slice it again for this printer, or correct the line, and upload it once more.';
  if (job.state === 'interrupted') return 'Look at the print: print it again from its beginning, or give it up.';
  if (job.state === 'failed') return 'Look at the printer before you print again.';
  return '';
}

// The picture that its check has made; read by a request, because an <img> sends no key.
function pictureOf(job) {
  const image = element('img', {alt: '', width: 56, height: 56});
  if (!pictures.has(job.id)) {
    pictures.set(job.id, fetched(`/api/v1/jobs/${job.id}/picture`, 'blob').then(blob => blob && new Promise(done => {
      const reader = new FileReader();
      reader.onload = () => done(reader.result);
      reader.readAsDataURL(blob);
    })));
  }
  pictures.get(job.id).then(data => { if (data) image.src = data; else pictures.delete(job.id); });
  return image;
}

async function showPath(job) {
  const view = new PathView(job.name);
  view.followLabel.hidden = true;
  setText(byId('path-title'), job.name);
  byId('path-place').replaceChildren(view.box);
  openDialog(byId('path-dialog'));
  await view.load(job);
  if (!view.path) show(`The path of ${job.name} cannot be read now; try again.`);
}

const mayCancel = what => ask(`Cancel ${what}? It cannot go on later.`, 'Cancel the print', 'Keep printing');

function buttonsOf(job) {
  const path = `/api/v1/jobs/${job.id}`, waits = !isOver(job) && !isActive(job);
  const buttons = element('div', {className: 'buttons'});
  if (waits) {
    buttons.append(jobButton(job, '↑', () => moveBy(job, waitingJobs(), -1), 'Move up'),
      jobButton(job, '↓', () => moveBy(job, waitingJobs(), 1), 'Move down'));
  }
  if (job.has_path) buttons.append(jobButton(job, 'Path', () => showPath(job), 'Show the path'));
  if (job.state === 'interrupted') buttons.append(jobButton(job, 'Print again', () => post(path + '/again')));
  if (waits && job.state !== 'interrupted') {
    buttons.append(job.held ? jobButton(job, 'Release', () => post(path + '/hold', {held: false}))
      : jobButton(job, 'Hold', () => post(path + '/hold', {held: true})));
  }
  if (!isOver(job)) {
    buttons.append(jobButton(job, job.state === 'interrupted' ? 'Give up' : 'Cancel',
      async () => (!isActive(job) || await mayCancel(`the print of ${job.name}`)) && post(path + '/cancel')));
  }
  if (isOver(job) && job.state !== 'refused') buttons.append(jobButton(job, 'Print again', () => post(path + '/again')));
  if (isOver(job)) buttons.append(jobButton(job, 'Remove', () => request('DELETE', path)));
  return buttons;
}

function makeRow(job) {
  const waits = !isOver(job) && !isActive(job);
  const item = element('li', {className: waits ? 'waits' : '', 'data-job': job.id});
  if (waits) item.append(handleOf(item, job, waitingJobs));
  if (job.has_picture) item.append(pictureOf(job));
  const advice = adviceFor(job);
  item.append(element('div', {className: 'about'}, element('span', {className: 'name'}, job.name),
    element('span', {className: 'what'}, describe(job)), ...advice ? [element('span', {className: 'advice'}, advice)] : []),
    buttonsOf(job));
  return item;
}

// A row stays as it is where its job does, so that a finger or the focus does not lose it.
function rowOf(job) {
  const text = nameOf(job) + JSON.stringify(job), row = rows.get(job.id);
  if (row && row.text === text) return row.item;
  const item = makeRow(job);
  rows.set(job.id, {text, item});
  return item;
}

function place(list, wanted) {
  for (const child of [...list.children]) if (!wanted.includes(child)) child.remove();
  wanted.forEach((item, i) => { if (list.children[i] !== item) list.insertBefore(item, list.children[i] || null); });
}

function tellChanges(old) {
  for (const job of jobs) {
    const before = old.find(each => each.id === job.id);
    if (before && before.state !== job.state && !['checking', 'starting'].includes(job.state)) {
      announce(`${job.name} is ${job.state}${job.reason ? `: ${job.reason}` : ''}`);
    }
  }
}

// On the same control of a row that has been made again; else on the row's first one, or near it.
function keepFocus(key) {
  const again = document.querySelector(`[data-key="${CSS.escape(key)}"]`) ||
    document.querySelector(`[data-job="${CSS.escape(key.split(' ')[0])}"] button`) || byId('queue-title');
  if (again !== document.activeElement) again.focus();
}

function showJobs(fresh = jobs) {
  if (fresh !== jobs) tellChanges(jobs);
  jobs = fresh;
  if (dragged) return;
  const focused = document.activeElement && document.activeElement.getAttribute('data-key');
  const open = [...jobs.filter(isActive), ...waitingJobs()];
  const over = jobs.filter(isOver).sort((a, b) => b.changed_ms - a.changed_ms);
  place(byId('queue'), open.map(rowOf));
  place(byId('over'), over.map(rowOf));
  for (const kept of [rows, pictures]) {
    for (const id of kept.keys()) if (!jobs.some(job => job.id === id)) kept.delete(id);
  }
  byId('empty').hidden = open.length > 0;
  byId('none-over').hidden = over.length > 0;
  if (focused) keepFocus(focused);
}
