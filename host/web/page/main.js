// SPDX-License-Identifier: Apache-2.0
// Shows each state as it comes.
let faultShown = '';

listen((state, isFirst) => {
  if (state.fault !== faultShown) show(state.fault && `The spooler cannot go on: ${state.fault}`);
  faultShown = state.fault;
  showPrinters(state);
  showWanted(state.printers);
  showJobs(state.jobs);
  const printing = state.printers.find(printer => printer.job && printer.commands);
  progressWords = printing ? `${(100 * printing.done / printing.commands).toFixed(0)} % – ` : '';
  if (!isFirst) return;
  for (const part of cards.values()) part.view.retry();
  loadTemperatures();
});
