// SPDX-License-Identifier: Apache-2.0
// Elements, words, and messages to people.
'use strict';
const byId = id => document.getElementById(id);

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'onclick') made.addEventListener('click', value);
    else if (name in made) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

function setText(node, text) { if (node.textContent !== text) node.textContent = text; }

// What has failed, and what to do. It stays until it is dismissed or something is done with success.
function show(text) {
  setText(byId('message-text'), text);
  byId('message').hidden = !text;
}
byId('dismiss').addEventListener('click', () => show(''));

// For screen readers, without a place on the page.
function announce(text) { byId('announcer').textContent = text; }

// Nothing outside of a dialog can be reached while it is open, so emergency stops and messages go into it.
// A promise of the value of the button that closes it; empty for Escape.
function openDialog(dialog) {
  dialog.prepend(byId('bar'));
  dialog.returnValue = '';
  dialog.showModal();
  return new Promise(done => dialog.addEventListener('close', () => {
    document.querySelector('.skip').after(byId('bar'));
    done(dialog.returnValue);
  }, {once: true}));
}

// Whether a person says yes. Unlike confirm() it stops neither the events nor the age of what is shown.
async function ask(question, yes, no) {
  setText(byId('question-text'), question);
  setText(byId('yes'), yes);
  setText(byId('no'), no);
  return await openDialog(byId('question')) === 'yes';
}

const clockTime = ms => new Date(ms).toLocaleTimeString();

function duration(seconds) {
  if (seconds < 60) return `${Math.max(0, seconds).toFixed(0)} s`;
  if (seconds < 3600) return `${Math.round(seconds / 60)} min`;
  return `${Math.floor(seconds / 3600)} h ${String(Math.floor(seconds / 60) % 60).padStart(2, '0')} min`;
}

// A canvas that is as sharp as the screen; `draw` gets a context in CSS pixels, again at each change
// of size or theme.
function sharpCanvas(canvas, draw) {
  const redraw = () => {
    const width = canvas.clientWidth, height = canvas.clientHeight, ratio = devicePixelRatio || 1;
    if (!width || !height) return;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    const context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    draw(context, width, height);
  };
  new ResizeObserver(redraw).observe(canvas);
  document.addEventListener('themechange', redraw);
  return redraw;
}
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
