// SPDX-License-Identifier: Apache-2.0
// The path of a job as the server has it (tools/planning/path_file.hpp), a layer at a time.
class PathData {
  static async of(job) {
    const head = await fetched(`/api/v1/jobs/${job}/path`, 'json');
    return head && head.layers.length && head.bounds_mm ? new PathData(job, head) : null;
  }

  constructor(job, head) {
    Object.assign(this, {job, unit: head.unit_mm, stepsPerMm: head.steps_per_mm, bounds: head.bounds_mm});
    this.layers = head.layers.map(([z, count, command]) => ({z, count, command}));
    this.kept = new Map();  // the layers used last
  }

  // A promise of {x, y: mm, command, extrudes: arrays}, or of null.
  layer(index) {
    if (index < 0 || index >= this.layers.length) return Promise.resolve(null);
    if (!this.kept.has(index)) {
      const reading = fetched(`/api/v1/jobs/${this.job}/path/${index}`, 'arrayBuffer').then(bytes => {
        if (!bytes) this.kept.delete(index);  // asked for again
        return bytes && this.read(bytes);
      });
      this.kept.set(index, reading);
      if (this.kept.size > 6) this.kept.delete(this.kept.keys().next().value);
    }
    return this.kept.get(index);
  }

  read(bytes) {
    const view = new DataView(bytes), count = bytes.byteLength / 8;
    const points = {x: new Float32Array(count), y: new Float32Array(count), command: new Uint32Array(count),
      extrudes: new Uint8Array(count)};
    for (let i = 0; i < count; ++i) {
      points.x[i] = view.getInt16(8 * i, true) * this.unit;
      points.y[i] = view.getInt16(8 * i + 2, true) * this.unit;
      const word = view.getUint32(8 * i + 4, true);
      points.command[i] = word >>> 1;
      points.extrudes[i] = word & 1;
    }
    return points;
  }

  // The last layer that begins with this command or before it.
  layerOf(command) {
    let low = 0, high = this.layers.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.layers[middle].command <= command) low = middle; else high = middle - 1;
    }
    return low;
  }

  // Where the head is, in mm, by the steps that the printer has counted.
  placeOf(position) { return position.steps.map((steps, axis) => steps / this.stepsPerMm[axis]); }
}

// So many commands at most are taken and not made yet: the 64 lines of the planner, and what is handed over or waits.
const mostAhead = 96;

const nearMm = 0.1;  // steps are exact, but points are rounded and some left out

// The place on the line to a point that is nearest to X, Y: {distance in mm, share of the line}.
function nearestOn(points, i, x, y) {
  const fromX = points.x[i - 1], fromY = points.y[i - 1];
  const dx = points.x[i] - fromX, dy = points.y[i] - fromY, length = dx * dx + dy * dy;
  const share = length ? Math.min(1, Math.max(0, ((x - fromX) * dx + (y - fromY) * dy) / length)) : 1;
  return {distance: Math.hypot(fromX + share * dx - x, fromY + share * dy - y), share};
}

// The part of the path on which the head stands: of what the printer has taken, the first line since `last` that
// goes through the place that it reports; lines that cross there later are not made yet. What is extruded must be
// at that height too. Null where it is on none.
async function partUnderWay(path, done, position, last) {
  if (!position) return null;
  const [x, y, z] = path.placeOf(position), end = path.layerOf(done);
  const first = path.layerOf(Math.max(1, done - mostAhead));
  for (let index = Math.max(first, last ? last.layer : 0); index <= end; ++index) {
    const points = await path.layer(index), isHere = Math.abs(path.layers[index].z - z) <= 0.15;
    if (!points) return null;
    for (let i = last && last.layer === index ? last.point : 1; i < points.x.length; ++i) {
      if (points.command[i] < done - mostAhead || points.command[i] > done + 1) continue;
      if (points.extrudes[i] && !isHere) continue;
      const {distance, share} = nearestOn(points, i, x, y);
      if (distance <= nearMm) return {layer: index, point: i, share};
    }
  }
  return null;
}
