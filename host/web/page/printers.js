// SPDX-License-Identifier: Apache-2.0
// A card for each printer.
const cards = new Map();
const degrees = ([now, target]) =>
  now === null ? '–' : `${now.toFixed(1)} °C${target ? ` → ${target.toFixed(0)} °C` : ''}`;

function wordsOf(printer, job) {
  if (!printer.feeder) return ['feeder starts …', 'warn'];
  if (printer.link === 'closed') return ['no port', 'bad'];
  if (printer.link !== 'ready') return ['does not answer', 'bad'];
  if (printer.waits_for_user) return ['waits for you', 'warn'];
  if (printer.phase === 'cancelling') return ['cancelling', 'warn'];
  if (job) return [job.state, job.state === 'paused' ? 'warn' : 'good'];
  return printer.bed_clear ? ['ready', 'good'] : ['is the bed clear?', 'warn'];
}

function makeCard(name) {
  const path = `/api/v1/printers/${name}/`;
  const part = {};
  const button = (id, text, action, kind = '') =>
    part[id] = element('button', {type: 'button', className: kind, onclick: action}, text);
  const line = element('input', {ariaLabel: `Line for ${name}`, placeholder: 'M105', maxLength: 96});
  const form = element('form', {className: 'typed'}, line, element('button', {}, 'Send'));
  form.addEventListener('submit', async event => {
    event.preventDefault();
    if (await post(path + 'send', {line: line.value})) line.value = '';
  });
  const graph = id => {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', '0 0 120 20');
    svg.setAttribute('preserveAspectRatio', 'none');
    svg.setAttribute('aria-hidden', 'true');
    part[id + 'Line'] = document.createElementNS('http://www.w3.org/2000/svg', 'polyline');
    svg.append(part[id + 'Line']);
    return svg;
  };
  const row = (id, label) => [element('dt', {}, label), element('dd', {}, graph(id)), part[id] = element('dd')];
  part.card = element('article', {className: 'card', ariaLabel: name},
    element('div', {className: 'top'}, element('h3', {}, name), part.state = element('span', {className: 'state', role: 'status'})),
    part.job = element('p', {className: 'job'}),
    part.progress = element('progress', {max: 1, value: 0, ariaLabel: 'progress'}),
    element('dl', {}, ...row('hotend', 'Hotend'), ...row('bed', 'Bed')),
    element('div', {className: 'buttons'},
      button('clear', 'The bed is clear', () => post(path + 'bed_clear', {clear: part.clear.dataset.to === 'true'}), 'main'),
      button('pause', 'Pause', () => post(path + 'pause')),
      button('resume', 'Resume', () => post(path + 'resume')),
      button('cancel', 'Cancel', () => confirm(`Cancel the print on ${name}?`) && post(path + 'cancel')),
      button('restart', 'Switch off and on', () => post(path + 'restart')),
      button('stop', 'Emergency stop', () => post(path + 'stop'), 'stop')),
    element('details', {}, element('summary', {}, 'Console'), part.console = element('pre', {tabIndex: 0}), form));
  part.courses = {hotend: [], bed: []};
  byId('printers').append(part.card);
  return part;
}

// The last minutes, as far as this page has seen them.
function draw(part, id, pair) {
  const course = part.courses[id];
  if (pair[0] !== null) course.push(pair[0]);
  if (course.length > 240) course.shift();
  const low = Math.min(20, ...course), high = Math.max(60, ...course);
  part[id + 'Line'].setAttribute('points', course.map((value, i) =>
    `${(120 * i / Math.max(1, course.length - 1)).toFixed(1)},${(19 - 18 * (value - low) / (high - low)).toFixed(1)}`).join(' '));
  part[id].textContent = degrees(pair);
}

const time = seconds => seconds < 60 ? `${seconds.toFixed(0)} s`
  : `${Math.floor(seconds / 3600)}:${String(Math.floor(seconds / 60) % 60).padStart(2, '0')} h`;

function showPrinter(printer, jobs) {
  if (!cards.has(printer.name)) cards.set(printer.name, makeCard(printer.name));
  const part = cards.get(printer.name);
  const job = jobs.find(each => each.id === printer.job);
  const [words, kind] = wordsOf(printer, job);
  if (part.state.textContent !== words) part.state.textContent = words;
  part.state.className = `state ${kind}`;
  const share = job && job.commands ? printer.done / job.commands : 0;
  part.job.textContent = job
    ? `${job.name}: line ${printer.done} of ${job.commands}, ${(100 * share).toFixed(1)} %, about ${time(job.seconds * (1 - share))} left`
    : printer.feeder_job ? `job ${printer.feeder_job}` : 'no job';
  if (printer.fault) part.job.textContent += `: ${printer.fault}`;
  part.progress.value = share;
  draw(part, 'hotend', printer.hotend);
  draw(part, 'bed', printer.bed);
  const busy = Boolean(job) || printer.phase === 'running' || printer.phase === 'paused';
  part.clear.hidden = busy;
  part.clear.dataset.to = String(!printer.bed_clear);
  part.clear.textContent = printer.bed_clear ? 'The bed is not clear' : 'The bed is clear';
  part.pause.disabled = printer.phase !== 'running';
  part.resume.disabled = printer.phase !== 'paused' && !printer.waits_for_user;
  part.cancel.disabled = !busy;
  part.restart.hidden = !printer.simulated;
  const text = printer.console.map(line => line.text).join('\n');
  if (part.console.textContent !== text) {
    const atEnd = part.console.scrollTop + part.console.clientHeight >= part.console.scrollHeight - 5;
    part.console.textContent = text;
    if (atEnd) part.console.scrollTop = part.console.scrollHeight;
  }
}
