// SPDX-License-Identifier: Apache-2.0
// Numbers as a person reads them, and the colours of the theme.
const number = (value, digits) => value.toFixed(digits).replace('-', '\u2212');

function lengthText(mm) {
  const size = Math.abs(mm);
  if (size < 0.9995) return `${number(mm * 1000, size < 0.0995 ? 1 : 0)} \u00b5m`;
  return size < 999.5 ? `${number(mm, size < 10 ? 3 : 2)} mm` : `${number(mm / 1000, 2)} m`;
}

function timeText(t, digits = 1) {
  if (t < 60) return `${number(t, digits)} s`;
  const whole = Math.floor(t / 60), minutes = whole % 60, hours = Math.floor(whole / 60);
  const seconds = (t - 60 * whole).toFixed(digits).padStart(digits ? 3 + digits : 2, '0');
  return hours ? `${hours}:${String(minutes).padStart(2, '0')}:${seconds}` :
                 `${minutes}:${seconds}`;
}

// 1, 2, 2.5 or 5 times a power of ten, so that about `count` of them fit.
function niceStep(span, count) {
  const raw = span / Math.max(count, 1), power = 10 ** Math.floor(Math.log10(raw));
  return power * ([ 1, 2, 2.5, 5 ].find((factor) => factor * power >= raw) || 10);
}
function niceTimeStep(span, count) {
  const raw = span / Math.max(count, 1);
  return raw < 10 ?
      niceStep(span, count) :
      [ 10, 15, 20, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14400 ].find((s) => s >= raw) ||
          36000;
}
// As few digits as show such steps apart.
function digitsFor(step) {
  let digits = 0;
  while (digits < 6 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6)
    ++digits;
  return digits;
}

const dark = window.matchMedia('(prefers-color-scheme: dark)');
const colour = (name) =>
    getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
const ramps = {
  light : [ '#3b2f80', '#2d6ca2', '#14907c', '#6aa61e', '#d99a00' ],
  dark : [ '#7d6bff', '#3fa2ea', '#2fcfae', '#a5dd4a', '#ffd84d' ]
};
const rampSteps = 32;

function rampColours() {
  const stops = ramps[dark.matches ? 'dark' : 'light'].map(
      (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)));
  return Array.from({length : rampSteps}, (_, i) => {
    const at = i / (rampSteps - 1) * (stops.length - 1),
          low = Math.min(Math.floor(at), stops.length - 2);
    const mix =
        stops[low].map((from, k) => Math.round(from + (at - low) * (stops[low + 1][k] - from)));
    return `rgb(${mix.join(',')})`;
  });
}

// A canvas as sharp as the screen; its context counts in CSS pixels.
function sharpContext(canvas, height) {
  const scale = window.devicePixelRatio || 1, width = canvas.clientWidth;
  const tall = height || canvas.clientHeight;
  if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(tall * scale)) {
    canvas.width = Math.round(width * scale);
    canvas.height = Math.round(tall * scale);
  }
  const context = canvas.getContext('2d');
  context.setTransform(scale, 0, 0, scale, 0, 0);
  context.clearRect(0, 0, width, tall);
  context.font = '12px system-ui, "Segoe UI", Roboto, Helvetica, Arial, sans-serif';
  context.textBaseline = 'alphabetic';
  return {context, width, height : tall};
}

function element(tag, attributes = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}
