// SPDX-License-Identifier: Apache-2.0
// The numbers of the print, unpacked: differences become values, and layers are found.
'use strict';
const data = JSON.parse(document.getElementById('print-data').textContent);

function sums(differences, scale) {
  const values = new Float64Array(differences.length);
  let sum = 0;
  for (let i = 0; i < differences.length; ++i) {
    sum += differences[i];
    values[i] = sum * scale;
  }
  return values;
}

function unpackedLine(line) {
  return {
    x : sums(line.x, 1e-3),
    y : sums(line.y, 1e-3),
    z : sums(line.z, 1e-3),
    t : sums(line.t, 1e-3),
    kind : line.kind,
    n : line.x.length,
    fileLine : line.line ? sums(line.line, 1) : null
  };
}

// Lowest and highest value of each bucket of time.
function unpackedRange(course) {
  const low = sums(course.low, course.scale);
  const high = low.map((value, i) => value + course.width[i] * course.scale);
  return {dt : course.dt, low, high, n : low.length};
}

const path = unpackedLine(data.path);
const asked = unpackedLine(data.asked);
const axes = data.axes.map((axis) => ({
                             ...axis,
                             position : unpackedRange(axis.position),
                             speed : unpackedRange(axis.speed),
                             acceleration : unpackedRange(axis.acceleration)
                           }));
const heaters = data.heaters.map(
    (heater) => ({
      name : heater.name,
      t : sums(heater.t, 1e-3),
      celsius : sums(heater.celsius, 0.01),
      duty : heater.duty,
      target : sums(heater.target, 0.1).map((celsius) => (celsius > 0 ? celsius : NaN))
    }));
const queueDepth = unpackedRange(data.chip.queue_depth);
const busy = unpackedRange(data.chip.busy_percent);
const endOfPrint = Math.max(data.seconds, 1e-3);

// Runs of extrusion at one height, in the order of printing. A climb of less than this while
// extruding (a spiral) is still the same layer.
const sameLayer = 0.04;
function foundLayers() {
  const layers = [];
  for (let i = 1; i < path.n; ++i) {
    if (path.kind[i] !== '1') continue;
    const layer = layers[layers.length - 1];
    if (layer && Math.abs(path.z[i] - layer.z) < sameLayer) {
      layer.last = i;
    } else {
      layers.push({z : path.z[i], first : i, last : i});
    }
  }
  return layers;
}
const layers = foundLayers();

// The greatest index with values[index] <= value, or 0.
function indexAt(values, value) {
  let low = 0, high = values.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (values[middle] <= value) low = middle;
    else
      high = middle - 1;
  }
  return low;
}

// The last layer that has begun by then.
function layerAt(t) {
  let layer = 0;
  while (layer + 1 < layers.length && path.t[layers[layer + 1].first - 1] <= t) ++layer;
  return layer;
}

function nozzleAt(t) {
  const i = indexAt(path.t, t), j = Math.min(i + 1, path.n - 1);
  const gap = path.t[j] - path.t[i];
  const part = gap > 0 ? Math.min(1, Math.max(0, (t - path.t[i]) / gap)) : 0;
  const between = (values) => values[i] + part * (values[j] - values[i]);
  return {index : i, x : between(path.x), y : between(path.y), z : between(path.z)};
}

// The speed of the nozzle on the way to each point, in mm/s.
const pathSpeed = new Float64Array(path.n);
for (let i = 1; i < path.n; ++i) {
  const way =
      Math.hypot(path.x[i] - path.x[i - 1], path.y[i] - path.y[i - 1], path.z[i] - path.z[i - 1]);
  const time = path.t[i] - path.t[i - 1];
  pathSpeed[i] = time > 0 ? way / time : 0;
}
