// SPDX-License-Identifier: Apache-2.0
// Which courses the page shows.
const marks = data.marks.map((mark) => [mark.t, 'bad']);
const underruns = data.chip.underruns.map(([t]) => [t, 'bad']);

function makeCharts() {
  new Chart('temperatures', { unit: '\u00b0C', height: 190, low: 0, high: 60, marks,
    series: heaters.flatMap((heater, i) => [
      { label: heater.name, tint: 'xz'[i], t: heater.t, values: heater.celsius },
      { label: 'target', tint: 'xz'[i], t: heater.t, values: heater.target, dashed: true, digits: 0 }]) });
  heaters.forEach((heater, i) => new Chart('temperatures', { title: `${heater.name}: heater duty`, unit: '%',
    height: 90, high: 100, series: [{ label: 'gate open', tint: 'xz'[i], t: heater.t, values: heater.duty, digits: 0 }] }));
  for (const i of [2, 3]) {
    new Chart('positions', { title: i === 2 ? 'Z, height' : 'E, filament pushed', unit: 'mm', height: 120, marks,
      low: Infinity, high: -Infinity,
      series: [{ label: axes[i].name, tint: 'xyze'[i], range: axes[i].position, digits: 3 }] });
  }
  axes.forEach((axis, i) => {
    const { speed, acceleration, jerk } = axis.limits, tint = 'xyze'[i];
    const kilohertz = speed * axis.limits.steps_per_mm / 1000;
    new Chart('speeds', { title: `${axis.name}: limit ${number(speed, 0)} mm/s (${
      number(kilohertz, 1)} kHz)`, unit: 'mm/s', height: 110, marks,
      limits: [{ value: speed }, { value: -speed }], series: [{ label: 'speed', tint, range: axis.speed }] });
    const jump = acceleration + jerk / data.half_window_s;
    new Chart('accelerations', { title: `${axis.name}: limit ${number(acceleration, 0)} mm/s\u00b2, with the jump at a corner ${
      number(jump, 0)}`, unit: 'mm/s\u00b2', height: 110, marks,
      limits: [{ value: acceleration }, { value: -acceleration }, { value: jump, dashed: true },
        { value: -jump, dashed: true }],
      series: [{ label: 'acceleration', tint, range: axis.acceleration, digits: 0 }] });
  });
  new Chart('chip', { title: 'Step generator: segments in the queue, underruns in red', unit: '', height: 110,
    high: 3, marks: underruns, series: [{ label: 'waiting', tint: 'accent', range: queueDepth, digits: 0 }] });
  new Chart('chip', { title: 'Processor', unit: '%', height: 110, high: 100, marks: underruns,
    series: [{ label: 'busy', tint: 'busy', range: busy, digits: 0 }] });
  charts.forEach(listenTo);
}

function drawCharts() { for (const chart of charts) chart.draw(); }

// How often each time between two steps of an axis occurred, both scales logarithmic.
function drawIntervals() {
  const canvas = document.getElementById('intervals');
  const { context, width, height } = sharpContext(canvas);
  const perDecade = data.intervals.bins_per_decade, counts = data.intervals.axes;
  const used = counts.flatMap((axis) => axis.flatMap((count, bin) => (count > 0 ? [bin] : [])));
  const first = Math.max(0, Math.min(...used, 1e9) - 3), last = Math.max(...used, 0) + 3;
  const most = Math.max(10, ...counts.flat()), decades = Math.ceil(Math.log10(most));
  const right = width - margin.right, low = height - margin.bottom;
  const x = (bin) => margin.left + (bin - first) / Math.max(1, last - first) * (right - margin.left);
  const y = (count) => low - Math.log10(Math.max(count, 0.7) / 0.7) / Math.log10(10 ** decades / 0.7) * (low - margin.top);
  context.strokeStyle = colour('grid');
  context.fillStyle = colour('dim');
  for (let power = 0; power <= decades; ++power) {
    context.beginPath(); context.moveTo(margin.left, y(10 ** power)); context.lineTo(right, y(10 ** power)); context.stroke();
    context.fillText(power < 4 ? String(10 ** power) : `10${'\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'[power] || '^' + power}`, 8, y(10 ** power) + 4);
  }
  const names = ['1 \u00b5s', '10 \u00b5s', '100 \u00b5s', '1 ms', '10 ms', '100 ms', '1 s'];
  context.textAlign = 'center';
  names.forEach((name, decade) => {
    const bin = decade * perDecade;
    if (bin < first || bin > last) return;
    context.beginPath(); context.moveTo(x(bin), margin.top); context.lineTo(x(bin), low); context.stroke();
    context.fillText(name, Math.min(x(bin), right - 14), height - 5);
  });
  context.textAlign = 'left';
  counts.forEach((axis, i) => {
    context.strokeStyle = colour('xyze'[i]);
    context.lineWidth = 1.5;
    context.beginPath();
    for (let bin = first; bin <= last; ++bin) {
      context.lineTo(x(bin), y(axis[bin] || 0));
      context.lineTo(x(bin + 1), y(axis[bin] || 0));
    }
    context.stroke();
  });
}
