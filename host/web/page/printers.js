// SPDX-License-Identifier: Apache-2.0
// A card for each printer.
const cards = new Map();

// Its state in words, whether that is good, and what a person can do about it.
function wordsOf(printer, job, jobs) {
  const reset = printer.simulated ? 'press “Switch off and on”' : 'switch it off and on';
  if (!printer.feeder) {
    return ['feeder starts …', 'warn',
      'The process that feeds it starts by itself. If this stays, feeder.log in the folder of --data says why.'];
  }
  if (printer.link === 'closed') {
    return ['no port', 'bad', 'Switch the printer on and plug its cable in; its port is tried again by itself.'];
  }
  if (printer.link !== 'ready') return ['does not answer', 'bad', `Is it on? After an emergency stop or an error, ${reset}.`];
  if (printer.waits_for_user) return ['waits for you', 'warn', 'Do what its last line in the console asks, then press Resume.'];
  if (printer.phase === 'cancelling') return ['cancelling', 'warn', 'Its heaters are being switched off.'];
  const restored = printer.hotend_to_restore;
  if (job && job.state === 'paused') {
    return ['paused', 'warn', restored
      ? `Its hotend was switched off after a long pause. Resume heats it to ${restored} °C and goes on.`
      : 'Press Resume to go on. In a long pause its hotend is switched off, and heated again before it goes on.'];
  }
  if (job && restored) return ['heating', 'good', `It goes on once the hotend has ${restored} °C again.`];
  if (job) return [job.state, 'good', ''];
  const broken = jobs.find(each => each.state === 'interrupted' && each.printer === printer.name);
  if (broken) return ['interrupted', 'bad', `In the queue, decide about ${broken.name}: print it again, or give it up.`];
  if (!printer.bed_clear) {
    return ['is the bed clear?', 'warn', 'Take the print off, then press “The bed is clear”; the next job starts then.'];
  }
  const next = jobs.find(each => each.state === 'queued' && !each.held && ['', printer.name].includes(each.wanted_printer));
  if (next && printer.filament_mm !== null && next.filament_mm > printer.filament_mm) {
    return ['too little filament', 'warn', `${next.name} needs ${metres(next.filament_mm)} m, ${metres(printer.filament_mm)} m is left. ` +
      'Put another spool on and enter what it holds, or empty the field.'];
  }
  return ['ready', 'good', ''];
}

const metres = mm => (mm / 1000).toFixed(2);

// What is left on the spool. Empty: not known, and no job waits for it.
function filamentField(part, path) {
  part.filament = element('input', {type: 'number', min: 0, max: 100000, step: 'any', 'aria-label': `Filament left in m: ${part.name}`});
  part.filament.addEventListener('change', () => {
    const text = part.filament.value;
    if (!part.filament.validity.valid) return show('Filament: enter the metres that are left, or nothing.');
    post(path + 'filament', {mm: text === '' ? null : 1000 * Number(text)});
  });
  return element('span', {className: 'filament'}, 'Filament left: ', part.filament, ' m');
}

function heaterRow(part, id, label, name) {
  const chart = new TemperatureChart(`${label} of ${name}`);
  part.charts[id] = chart;
  const values = part[id] = {};
  for (const value of ['now', 'target', 'duty']) values[value] = element('span', {className: value});
  const title = element('div', {className: 'top value'},
    element('span', {}, element('span', {className: 'label'}, label), ' ', values.now),
    element('span', {}, values.target, ' ', values.duty));
  return element('div', {className: 'heater'}, title, chart.canvas);
}

const mayRestart = name => ask(`Switch ${name} off and on? Its print ends.`, 'Switch off and on', 'Keep printing');

function makeCard(name) {
  const path = `/api/v1/printers/${name}/`;
  const part = {charts: {}, name};
  const button = (id, text, action, kind = '') =>
    part[id] = element('button', {type: 'button', className: kind, 'aria-label': `${text}: ${name}`, onclick: action}, text);
  part.console = new Console(name);
  part.view = new PathView(name);
  part.card = element('article', {className: 'card', 'aria-label': name},
    element('div', {className: 'top'}, element('h2', {}, name),
      part.state = element('span', {className: 'state', role: 'status'})),
    part.stale = element('p', {className: 'age', hidden: true}),
    part.advice = element('p', {className: 'advice'}),
    element('p', {className: 'job'}, part.jobName = element('span', {className: 'name'}), ' ',
      part.job = element('span', {className: 'what'})),
    part.progress = element('progress', {max: 1, value: 0, 'aria-label': `Progress on ${name}`}),
    element('div', {className: 'buttons'},
      button('clear', 'The bed is clear', () => post(path + 'bed_clear', {clear: part.clear.dataset.to === 'true'}), 'main'),
      button('pause', 'Pause', () => post(path + part.pause.dataset.does)),
      button('cancel', 'Cancel', async () => await mayCancel(`the print on ${name}`) && post(path + 'cancel')),
      button('restart', 'Switch off and on',
        async () => (part.cancel.disabled || await mayRestart(name)) && post(path + 'restart')),
      filamentField(part, path)),
    element('div', {className: 'views'},
      element('div', {className: 'heaters'}, heaterRow(part, 'hotend', 'Hotend', name), heaterRow(part, 'bed', 'Bed', name)),
      part.view.box),
    part.console.box);
  part.stop = element('button', {type: 'button', className: 'stop', 'aria-label': `Emergency stop: ${name}`,
    onclick: () => stopNow(name)});
  byId('printers').append(part.card);
  byId('stops').append(part.stop);
  return part;
}

// At once, without a question.
async function stopNow(name) {
  const why = await refusal('POST', `/api/v1/printers/${name}/stop`);
  show(why ? `${name} was NOT stopped. Switch it off at its mains switch. The reason: ${why}` : '');
  if (!why) announce(`${name} is stopped`);
}

function showHeater(part, id, triple, time, answers) {
  const [now, target, duty] = triple, values = part[id];
  setText(values.now, now === null ? 'not known' : `${now.toFixed(1)} °C`);
  setText(values.target, now === null ? '' : target ? `target ${target.toFixed(0)} °C` : 'off');
  setText(values.duty, duty === null ? '' : `duty ${(100 * duty).toFixed(0)} %`);
  values.target.hidden = now === null;
  values.target.classList.toggle('off', !target);
  values.duty.hidden = duty === null;
  part.charts[id].take(triple, time, answers);
}

function showJob(part, printer, job) {
  const share = job && job.commands ? printer.done / job.commands : 0;
  setText(part.jobName, job ? job.name : '');
  const left = job && `about ${duration(job.seconds * (1 - share))} left`;
  setText(part.job, job ? `${(100 * share).toFixed(1)} %, ${left}, line ${printer.done} of ${job.commands}`
    : printer.feeder_job ? `job ${printer.feeder_job}` : 'no job');
  part.progress.value = share;
  part.progress.hidden = !job;
}

// A button that changes its words keeps its place and the focus.
function rename(button, words, part) {
  setText(button, words);
  button.setAttribute('aria-label', `${words}: ${part.name}`);
}

function showButtons(part, printer, job) {
  const busy = Boolean(job) || ['running', 'paused', 'opening', 'cancelling'].includes(printer.phase);
  part.clear.hidden = busy;
  part.clear.dataset.to = String(!printer.bed_clear);
  rename(part.clear, printer.bed_clear ? 'The bed is not clear' : 'The bed is clear', part);
  part.clear.classList.toggle('main', !printer.bed_clear);
  const stands = printer.phase === 'paused' || printer.waits_for_user;
  part.pause.dataset.does = stands ? 'resume' : 'pause';
  part.pause.disabled = !stands && printer.phase !== 'running';
  part.pause.classList.toggle('main', stands);
  rename(part.pause, stands ? 'Resume' : 'Pause', part);
  part.cancel.disabled = !busy;
  part.restart.hidden = !printer.simulated;
}

function showFilament(part, left) {
  if (document.activeElement === part.filament) return;  // a person types
  const text = left === null ? '' : String(Number(metres(left)));
  if (part.filament.value !== text) part.filament.value = text;
}

function showPrinter(printer, state) {
  if (!cards.has(printer.name)) cards.set(printer.name, makeCard(printer.name));
  const part = cards.get(printer.name);
  const job = state.jobs.find(each => each.id === printer.job);
  const [words, kind, advice] = wordsOf(printer, job, state.jobs);
  setText(part.state, words);
  part.state.className = `state ${kind}`;
  setText(part.advice, [printer.fault, advice].filter(Boolean).join(' '));
  // What a printer that does not answer has said last is from then.
  const answers = printer.feeder && printer.link === 'ready';
  part.card.classList.toggle('stale', !answers);
  part.stale.hidden = answers;
  setText(part.stale, answers ? '' : printer.answered_ms
    ? `No answer since ${clockTime(printer.answered_ms - state.now_ms + Date.now())}: the values are from then.`
    : 'It has not answered yet.');
  showJob(part, printer, job);
  showHeater(part, 'hotend', printer.hotend, state.now_ms, answers);
  showHeater(part, 'bed', printer.bed, state.now_ms, answers);
  showButtons(part, printer, job);
  showFilament(part, printer.filament_mm);
  part.console.show(printer.console);
  part.view.load(job).then(() => part.view.progress(printer.done, answers ? printer.position : null));
}

// Printers that this server does not have (any more) are not shown.
function showPrinters(state) {
  const names = state.printers.map(printer => printer.name);
  for (const [name, part] of cards) {
    if (names.includes(name)) continue;
    part.card.remove();
    part.stop.remove();
    cards.delete(name);
  }
  state.printers.forEach(printer => showPrinter(printer, state));
  for (const part of cards.values()) setText(part.stop, cards.size > 1 ? `STOP ${part.name}` : 'Emergency stop');
}

// What happened before this page was opened, or while it was not connected.
async function loadTemperatures() {
  for (const [name, part] of cards) {
    const log = await fetched(`/api/v1/printers/${name}/temperatures`, 'json');
    if (!log) continue;
    part.charts.hotend.load(log.samples.map(each => [each[0], each[1], each[2], each[3]]));
    part.charts.bed.load(log.samples.filter(each => each[4] !== null).map(each => [each[0], each[4], each[5], each[6]]));
  }
}
setInterval(() => {
  for (const part of cards.values()) Object.values(part.charts).forEach(chart => chart.redraw());
}, 2000);
