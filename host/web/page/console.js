// SPDX-License-Identifier: Apache-2.0
// What a printer says, and lines to it.
const mostConsoleLines = 300;

class Console {
  constructor(name) {
    this.name = name;
    this.last = 0;  // number of the last line shown
    this.history = [];
    this.at = 0;
    this.lines = element('div', {className: 'lines', role: 'log', tabIndex: 0, 'aria-label': `What ${name} says`});
    this.input = element('input', {'aria-label': `Line for ${name}`, placeholder: 'M105', maxLength: 96,
      autocomplete: 'off', autocapitalize: 'characters', spellcheck: false});
    this.refused = element('p', {className: 'refused', role: 'status'});
    const form = element('form', {className: 'typed'}, this.input,
      element('button', {'aria-label': `Send to ${name}`}, 'Send'));
    form.addEventListener('submit', event => { event.preventDefault(); this.send(); });
    this.input.addEventListener('keydown', event => this.recall(event));
    this.box = element('details', {className: 'console'}, element('summary', {}, 'Console'), this.lines, form, this.refused);
  }

  async send() {
    const line = this.input.value.trim();
    if (!line) return;
    const why = await refusal('POST', `/api/v1/printers/${this.name}/send`, {line});
    setText(this.refused, why ? `Not sent: ${why}.` : '');
    if (why) return;
    this.history.push(line);
    this.at = this.history.length;
    if (this.input.value.trim() === line) this.input.value = '';  // it may be the next one already
  }

  // Lines sent before, with the arrow keys.
  recall(event) {
    const step = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (!step || !this.history.length) return;
    event.preventDefault();
    this.at = Math.min(this.history.length, Math.max(0, this.at + step));
    this.input.value = this.history[this.at] || '';
  }

  // The server's last lines with their numbers, which begin again with it.
  show(lines) {
    const newest = lines.length ? lines[lines.length - 1].number : 0;
    if (newest < this.last) {
      this.lines.replaceChildren();
      this.last = 0;
    }
    const fresh = lines.filter(line => line.number > this.last);
    if (!fresh.length) return;
    const atEnd = this.lines.scrollTop + this.lines.clientHeight >= this.lines.scrollHeight - 5;
    this.lines.append(...fresh.map(line =>
      element('div', {className: line.text.startsWith('>') ? 'sent' : ''}, line.text)));
    while (this.lines.children.length > mostConsoleLines) this.lines.firstChild.remove();
    this.last = newest;
    if (atEnd) this.lines.scrollTop = this.lines.scrollHeight;
  }
}
