// SPDX-License-Identifier: Apache-2.0
// Shows each state as it comes.
let faultShown = '';

// What belongs to other spoolers on the same queue, and a queue that cannot be read now.
function showFarm(state) {
  const others = state.other_printers.map(each =>
    `${each.name} on ${each.place}${each.lease === 'held' ? '' : ' (its spooler is away)'}`);
  byId('others').hidden = others.length === 0;
  setText(byId('others'), `Printers of other spoolers, to be worked there: ${others.join(', ')}.`);
  byId('queue-age').hidden = !state.queue_is_old;
  setText(byId('queue-age'), state.queue_is_old
    ? `The queue's database is away: the jobs are shown as at ${clockTime(state.queue_ms - state.now_ms + Date.now())}.` : '');
}

listen((state, isFirst) => {
  if (state.fault !== faultShown) show(state.fault && `The spooler cannot go on: ${state.fault}`);
  faultShown = state.fault;
  showPrinters(state);
  showFarm(state);
  showWanted([...state.printers, ...state.other_printers]);
  showJobs(state.jobs);
  const printing = state.printers.find(printer => printer.job && printer.commands);
  progressWords = printing ? `${(100 * printing.done / printing.commands).toFixed(0)} % – ` : '';
  if (!isFirst) return;
  for (const part of cards.values()) part.view.retry();
  loadTemperatures();
});
