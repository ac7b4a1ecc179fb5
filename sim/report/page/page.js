// SPDX-License-Identifier: Apache-2.0
// Sliders, buttons and links: one time and one layer for the whole page.
const at = (id) => document.getElementById(id);
const timeSlider = at('time'), layerSlider = at('layer');
const sliderSteps = 2000;
const pathStart = layers.length ? path.t[layers[0].first - 1] : 0;
const pathEnd = path.n ? Math.max(path.t[path.n - 1], pathStart + 1e-3) : endOfPrint;
let timer = 0;

function setTime(t, layer = layerAt(t)) {
  view.t = Math.min(endOfPrint, Math.max(0, t));
  view.layer = layers.length ? layer : 0;
  timeSlider.value = Math.round(
      Math.min(1, Math.max(0, (view.t - pathStart) / (pathEnd - pathStart))) * sliderSteps);
  layerSlider.value = view.layer + 1;
  at('layer-out').textContent = layers.length ?
      `${view.layer + 1}/${layers.length} \u00b7 ${number(layers[view.layer].z, 2)} mm` :
      'none';
  at('time-out').textContent = timeText(view.t, 2);
  const place = nozzleAt(view.t);
  at('now').textContent =
      `X ${number(place.x, 3)}  Y ${number(place.y, 3)}  Z ${number(place.z, 3)} mm  \u00b7  ${
          number(
              pathSpeed[Math.min(place.index + 1, path.n - 1)] || 0,
              1)} mm/s  \u00b7  about line ${lineAt(view.t)}`;
  drawPath();
  drawCharts();
}

// The last line of the file that the chip had answered by then. Motion follows its answer, so this
// is ahead.
function lineAt(t) { return asked.n ? asked.fileLine[indexAt(asked.t, t)] : '\u2013'; }

function setLayer(index) {
  if (layers.length)
    setTime(index === layers.length - 1 ? pathEnd : path.t[layers[index].last], index);
}

function play() {
  const button = at('play');
  if (timer) {
    cancelAnimationFrame(timer);
    timer = 0;
    button.textContent = 'Play';
    return;
  }
  button.textContent = 'Stop';
  if (view.t >= pathEnd - 1e-3) setTime(pathStart);
  const seconds = 25, started = performance.now(), from = view.t;
  const step = (now) => {
    const t = from + (now - started) / 1000 / seconds * (pathEnd - pathStart);
    setTime(Math.min(t, pathEnd));
    if (t >= pathEnd) {
      timer = 0;
      button.textContent = 'Play';
    } else {
      timer = requestAnimationFrame(step);
    }
  };
  timer = requestAnimationFrame(step);
}

function toggle(id, name, after = drawPath) {
  const button = at(id);
  button.setAttribute('aria-pressed', view[name]);
  button.addEventListener('click', () => {
    view[name] = !view[name];
    button.setAttribute('aria-pressed', view[name]);
    after();
  });
}

function showRamp() {
  const [low, high] = view.byspeed ?
      [ '0', `${number(fastestPrinted(), 0)} mm/s` ] :
      layers.length ?
      [ Math.min, Math.max ].map((pick) => `${number(pick(...layers.map((l) => l.z)), 2)} mm`) :
      [ '', '' ];
  at('ramp-low').textContent = low;
  at('ramp-high').textContent = high;
  at('ramp').style.background = `linear-gradient(90deg, ${rampColours().join(',')})`;
}

// A link to a time, and to places if it has any.
function follow(link) {
  const t = Number(link.dataset.t), {places} = link.dataset;
  setTime(t);
  const around = Math.min(2, endOfPrint / 2);
  showSpan(t - around, t + around);
  if (places) lookAt(places.split(' ').map(Number));
}

// What an address asks for: report.html?in-space&by-speed&t=83.5&from=80&to=90&only=speeds. Names of
// buttons press them; `only` shows one section.
function followAddress() {
  const parameters = new URLSearchParams(location.search);
  const only = at(parameters.get('only'))?.closest('section');
  if (only) {
    document.querySelectorAll('main > *').forEach((part) => part.hidden = part !== only);
  }
  for (const name of parameters.keys()) {
    if (at(name)?.hasAttribute('aria-pressed')) at(name).click();
  }
  if (parameters.has('t')) setTime(Number(parameters.get('t')));
  if (parameters.has('from')) {
    showSpan(Number(parameters.get('from')), Number(parameters.get('to')));
  }
}

function drawAll() {
  showRamp();
  drawPath();
  drawCharts();
  drawIntervals();
}

function start() {
  makeCharts();
  fitPath();
  layerSlider.max = Math.max(1, layers.length);
  timeSlider.addEventListener(
      'input', () => setTime(pathStart + timeSlider.value / sliderSteps * (pathEnd - pathStart)));
  layerSlider.addEventListener('input', () => setLayer(layerSlider.value - 1));
  toggle('in-space', 'inSpace', () => {
    fitPath();
    drawPath();
  });
  toggle('by-speed', 'byspeed', () => {
    showRamp();
    drawPath();
  });
  toggle('show-asked', 'asked');
  toggle('show-travel', 'travel');
  toggle('one-layer', 'oneLayer');
  at('play').addEventListener('click', play);
  at('fit').addEventListener('click', () => {
    fitPath();
    drawPath();
  });
  const middle = () => ({x : pathCanvas.clientWidth / 2, y : pathCanvas.clientHeight / 2});
  at('closer').addEventListener('click', () => zoomPath(1.6, middle()));
  at('farther').addEventListener('click', () => zoomPath(1 / 1.6, middle()));
  document.querySelectorAll('[data-span]')
      .forEach((button) => button.addEventListener('click', () => {
        if (button.dataset.span === 'whole') showSpan(0, endOfPrint);
        else if (button.dataset.span === 'printing')
          showSpan(pathStart, pathEnd);
        else
          zoomSpan(button.dataset.span === 'closer' ? 0.5 : 2, (span.t0 + span.t1) / 2);
      }));
  document.querySelectorAll('a[data-t]')
      .forEach((link) => link.addEventListener('click', () => follow(link)));
  window.addEventListener('resize', () => {
    fitPath();
    drawAll();
  });
  dark.addEventListener('change', drawAll);
  setTime(pathEnd, Math.max(0, layers.length - 1));
  drawAll();
  followAddress();
}
start();
