// SPDX-License-Identifier: Apache-2.0
// How often each time between two steps of an axis occurred, both scales logarithmic.
const superscripts = [...'\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079'];

function drawIntervals() {
  const canvas = document.getElementById('intervals');
  const {context, width, height} = sharpContext(canvas);
  const perDecade = data.intervals.bins_per_decade, counts = data.intervals.axes;
  const used = counts.flatMap((axis) => axis.flatMap((count, bin) => (count > 0 ? [ bin ] : [])));
  const first = Math.max(0, Math.min(...used, 1e9) - 3), last = Math.max(...used, 0) + 3;
  const most = Math.max(10, ...counts.flat()), decades = Math.ceil(Math.log10(most));
  const right = width - margin.right, low = height - margin.bottom;
  const x = (bin) =>
      margin.left + (bin - first) / Math.max(1, last - first) * (right - margin.left);
  const y = (count) => low -
      Math.log10(Math.max(count, 0.7) / 0.7) / Math.log10(10 ** decades / 0.7) * (low - margin.top);
  context.strokeStyle = colour('grid');
  context.fillStyle = colour('dim');
  for (let power = 0; power <= decades; ++power) {
    context.beginPath();
    context.moveTo(margin.left, y(10 ** power));
    context.lineTo(right, y(10 ** power));
    context.stroke();
    const label = power < 4 ? String(10 ** power) : `10${superscripts[power]}`;
    context.fillText(label, 8, y(10 ** power) + 4);
  }
  const names = [ '1 \u00b5s', '10 \u00b5s', '100 \u00b5s', '1 ms', '10 ms', '100 ms', '1 s' ];
  context.textAlign = 'center';
  names.forEach((name, decade) => {
    const bin = decade * perDecade;
    if (bin < first || bin > last) return;
    context.beginPath();
    context.moveTo(x(bin), margin.top);
    context.lineTo(x(bin), low);
    context.stroke();
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
