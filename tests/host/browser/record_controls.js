// SPDX-License-Identifier: Apache-2.0
// Notes from now on which kinds of controls can be seen and which are used: what a control is called, without the
// printer or the job that it is for.
window.controls = {seen: new Set(), used: new Set()};
const selector = 'button, input, select, summary, a, .lines, .chart';
const kind = control => {
  const words = control.labels && control.labels.length ? control.labels[0] : control;
  const name = control.getAttribute('aria-label') || control.id || words.textContent.trim();
  return name.split(/:| \(job|, last/)[0].replace(/ (of|for|to) .*/, '').replace(/^(Move|STOP|What) .*\.gcode$/, '$1')
    .replace(/^What .* says$/, 'What it says');
};
const use = event => {
  const control = event.target.closest && event.target.closest(selector);
  if (control) controls.used.add(kind(control));
};
for (const type of ['click', 'input', 'keydown', 'pointerdown', 'pointermove']) addEventListener(type, use, true);
const see = () => {
  for (const each of document.querySelectorAll(selector)) {
    if (each.checkVisibility() && !each.disabled) controls.seen.add(kind(each));
  }
};
see();
new MutationObserver(see).observe(document, {subtree: true, childList: true, attributes: true, characterData: true});
