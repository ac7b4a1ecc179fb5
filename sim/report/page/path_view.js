// SPDX-License-Identifier: Apache-2.0
// The path as printed over the lines of the G-code, to look at from above or in space.
const view = {
  inSpace : false,
  byspeed : false,
  asked : true,
  travel : true,
  oneLayer : false,
  t : endOfPrint,
  azimuth : -0.6,
  elevation : 0.6,
  scale : 1,
  u : 0,
  v : 0,
  layer : Math.max(0, layers.length - 1)
};
const pathCanvas = document.getElementById('path-canvas');

function projected(x, y, z) {
  if (!view.inSpace) return [ x, y ];
  const cos = Math.cos(view.azimuth), sin = Math.sin(view.azimuth);
  return [
    x * cos - y * sin, (x * sin + y * cos) * Math.sin(view.elevation) + z * Math.cos(view.elevation)
  ];
}
function onScreen(x, y, z) {
  const [u, v] = projected(x, y, z);
  return [
    pathCanvas.clientWidth / 2 + (u - view.u) * view.scale,
    pathCanvas.clientHeight / 2 - (v - view.v) * view.scale
  ];
}

// What was printed, or all of it where nothing was, fills the canvas.
function fitPath() {
  let left = Infinity, right = -Infinity, low = Infinity, high = -Infinity;
  const add = (line, any) => {
    for (let i = any ? 0 : 1; i < line.n; ++i) {
      if (!any && line.kind[i] !== '1') continue;
      for (const k of any ? [ i ] : [ i - 1, i ]) {
        const [u, v] = projected(line.x[k], line.y[k], line.z[k]);
        left = Math.min(left, u);
        right = Math.max(right, u);
        low = Math.min(low, v);
        high = Math.max(high, v);
      }
    }
  };
  add(path, layers.length === 0);
  if (layers.length === 0) add(asked, true);
  if (!(right >= left)) {
    left = low = 0;
    right = high = 10;
  }
  view.u = (left + right) / 2;
  view.v = (low + high) / 2;
  const room = 0.88;
  view.scale = room *
      Math.min(
          pathCanvas.clientWidth / Math.max(right - left, 1),
          pathCanvas.clientHeight / Math.max(high - low, 1));
}

function drawGrid(context, width, height) {
  if (view.inSpace) return;
  const step = niceStep(width / view.scale, width / 110);
  context.strokeStyle = colour('grid');
  context.fillStyle = colour('dim');
  context.lineWidth = 1;
  const digits = digitsFor(step);
  for (let x = Math.ceil((view.u - width / 2 / view.scale) / step) * step;; x += step) {
    const at = width / 2 + (x - view.u) * view.scale;
    if (at > width) break;
    context.beginPath();
    context.moveTo(at, 0);
    context.lineTo(at, height);
    context.stroke();
    context.fillText(number(x, digits), at + 3, height - 5);
  }
  for (let y = Math.ceil((view.v - height / 2 / view.scale) / step) * step;; y += step) {
    const at = height / 2 - (y - view.v) * view.scale;
    if (at < 0) break;
    context.beginPath();
    context.moveTo(0, at);
    context.lineTo(width, at);
    context.stroke();
    context.fillText(number(y, digits), 4, at - 3);
  }
  context.fillText('mm', 4, 14);
}

// Calls back with the ends on the screen of every segment first..last that may be seen.
function eachSegment(line, first, last, width, height, use) {
  let [x0, y0] =
      first > 0 ? onScreen(line.x[first - 1], line.y[first - 1], line.z[first - 1]) : [ 0, 0 ];
  for (let i = Math.max(first, 1); i <= last; ++i) {
    if (i === 1) [x0, y0] = onScreen(line.x[0], line.y[0], line.z[0]);
    const [x1, y1] = onScreen(line.x[i], line.y[i], line.z[i]);
    if (Math.max(x0, x1) > -9 && Math.min(x0, x1) < width + 9 && Math.max(y0, y1) > -9 &&
        Math.min(y0, y1) < height + 9) {
      use(i, x0, y0, x1, y1);
    }
    [x0, y0] = [ x1, y1 ];
  }
}

// So many millimetres, but neither too thin nor too thick for the eye.
function widthOf(mm, least, most) { return Math.min(most, Math.max(least, mm * view.scale)); }

function drawRequested(context, width, height) {
  const z = layers.length ? layers[view.layer].z : 0;
  const until = layers.length ? path.t[layers[view.layer].last] : endOfPrint;
  const top = view.layer >= layers.length - 1;
  const bands = {1 : new Path2D(), 2 : new Path2D(), 3 : new Path2D()};
  eachSegment(asked, 1, asked.n - 1, width, height, (i, x0, y0, x1, y1) => {
    const kind = asked.kind[i];
    if (kind === '0' || (view.oneLayer && Math.abs(asked.z[i] - z) > sameLayer)) return;
    if (!top && asked.t[i] > until) return;
    bands[kind].moveTo(x0, y0);
    bands[kind].lineTo(x1, y1);
  });
  context.lineCap = 'round';
  if (view.asked) {
    context.strokeStyle = colour('asked');
    context.lineWidth = widthOf(0.4, 3, 9);
    context.stroke(bands[2]);
    if (view.travel) {
      context.lineWidth = 2.5;
      context.stroke(bands[1]);
    }
  }
  context.strokeStyle = colour('bad');
  context.lineWidth = 2;
  context.setLineDash([ 6, 5 ]);
  context.stroke(bands[3]);
  context.setLineDash([]);
}

function drawPrinted(context, width, height) {
  const end = nozzleAt(view.t).index;
  const first = view.oneLayer && layers.length ? Math.max(1, layers[view.layer].first) : 1;
  const zs = layers.map((layer) => layer.z), z0 = Math.min(...zs), z1 = Math.max(...zs);
  const fastest = view.byspeed ? fastestPrinted() : 1;
  const bins = Array.from({length : rampSteps}, () => new Path2D()), travel = new Path2D();
  eachSegment(path, first, end, width, height, (i, x0, y0, x1, y1) => {
    let target = travel;
    if (path.kind[i] === '1') {
      const part =
          view.byspeed ? pathSpeed[i] / fastest : (z1 > z0 ? (path.z[i] - z0) / (z1 - z0) : 0.5);
      target = bins[Math.max(0, Math.min(rampSteps - 1, Math.round(part * (rampSteps - 1))))];
    }
    target.moveTo(x0, y0);
    target.lineTo(x1, y1);
  });
  if (view.travel) {
    context.strokeStyle = colour('travel');
    context.lineWidth = 1;
    context.stroke(travel);
  }
  context.lineWidth = widthOf(0.12, 1.2, 2.4);
  rampColours().forEach((tint, i) => {
    context.strokeStyle = tint;
    context.stroke(bins[i]);
  });
  const nozzle = nozzleAt(view.t), [ x, y ] = onScreen(nozzle.x, nozzle.y, nozzle.z);
  context.strokeStyle = colour('nozzle');
  context.lineWidth = 2;
  context.beginPath();
  context.arc(x, y, 5, 0, 7);
  context.stroke();
}

let fastest = 0;
function fastestPrinted() {
  if (fastest === 0) {
    const speeds =
        Array.from(pathSpeed).filter((_, i) => path.kind[i] === '1').sort((a, b) => a - b);
    fastest = Math.max(1e-3, speeds[Math.floor(0.995 * (speeds.length - 1))] || 0);
  }
  return fastest;
}

function drawMissed(context) {
  context.strokeStyle = colour('bad');
  context.lineWidth = 2;
  for (const point of data.missed) {
    const [x, y] = onScreen(point.x, point.y, point.z);
    const [rx, ry] = onScreen(point.reached_x, point.reached_y, point.reached_z);
    context.beginPath();
    context.arc(x, y, 6, 0, 7);
    context.moveTo(x - 3, y - 3);
    context.lineTo(x + 3, y + 3);
    context.moveTo(x - 3, y + 3);
    context.lineTo(x + 3, y - 3);
    context.moveTo(x, y);
    context.lineTo(rx, ry);
    context.stroke();
  }
}

function drawPath() {
  const {context, width, height} = sharpContext(pathCanvas);
  if (width === 0 || height === 0) return;  // hidden
  drawGrid(context, width, height);
  drawRequested(context, width, height);
  drawPrinted(context, width, height);
  drawMissed(context);
}
