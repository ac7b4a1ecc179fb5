// SPDX-License-Identifier: Apache-2.0
// The last minutes of a heater: temperature, target, and duty. Times are the server's.
const chartSpans = [2, 5, 10, 30];  // minutes; the shortest that shows all samples
const gapMs = 7000;  // samples that are farther apart are not joined

class TemperatureChart {
  constructor(label) {
    this.label = label;
    this.samples = [];  // [time in ms, °C, target, duty 0 to 1]
    this.offset = 0;  // of the server's clock
    this.pointer = null;
    this.canvas = element('canvas', {className: 'chart', role: 'img'});
    this.redraw = sharpCanvas(this.canvas, (context, width, height) => this.draw(context, width, height));
    this.canvas.addEventListener('pointermove', event => { this.pointer = event.offsetX; this.redraw(); });
    this.canvas.addEventListener('pointerleave', () => { this.pointer = null; this.redraw(); });
  }

  // Minutes shown at this time.
  span(time) {
    const known = this.samples.length ? (time - this.samples[0][0]) / 60000 : 0;
    return chartSpans.find(minutes => known <= minutes) || chartSpans[chartSpans.length - 1];
  }

  // All that the server has.
  load(samples) {
    this.samples = samples;
    this.redraw();
  }

  // The heater's present values; the server's time, and whether the printer answers.
  take([now, target, duty], time, answers) {
    this.offset = time - Date.now();
    const last = this.samples[this.samples.length - 1];
    if (answers && now !== null && (!last || time - last[0] >= 1000)) this.samples.push([time, now, target, duty]);
    while (this.samples.length && this.samples[0][0] < time - chartSpans[chartSpans.length - 1] * 60000) this.samples.shift();
    this.describe(time);
    this.redraw();
  }

  describe(time) {
    const temperatures = this.samples.map(sample => sample[1]);
    const last = this.samples[this.samples.length - 1];
    const words = !last ? 'nothing known yet' : `from ${Math.min(...temperatures).toFixed(0)} to ${
      Math.max(...temperatures).toFixed(0)} °C, at last ${last[1].toFixed(1)} °C at ${clockTime(last[0] - this.offset)}`;
    const label = `${this.label}, last ${this.span(time)} minutes: ${words}`;
    if (this.canvas.getAttribute('aria-label') !== label) this.canvas.setAttribute('aria-label', label);
  }

  draw(context, width, height) {
    const end = Date.now() + this.offset, span = this.span(end), begin = end - span * 60000;
    const shown = this.samples.filter(sample => sample[0] >= begin - gapMs);
    const values = shown.flatMap(sample => [sample[1], sample[2] || 0]);
    const high = Math.ceil((Math.max(50, ...values) + 10) / 50) * 50, low = 0;
    const left = 34, right = width - 42, top = 6, bottom = height - 16;
    const x = time => left + (right - left) * (time - begin) / (end - begin);
    const y = value => bottom - (bottom - top) * (value - low) / (high - low);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = colour('quiet');
    context.strokeStyle = colour('line');
    context.lineWidth = 1;
    context.textBaseline = 'middle';
    for (const part of [0, 0.5, 1]) {
      const level = low + (high - low) * part;
      context.beginPath();
      context.moveTo(left, y(level));
      context.lineTo(right, y(level));
      context.stroke();
      context.textAlign = 'right';
      context.fillText(`${level.toFixed(0)}°`, left - 4, y(level));
      context.textAlign = 'left';
      context.fillText(`${(100 * part).toFixed(0)} %`, right + 4, y(level));
    }
    context.textAlign = 'center';
    context.textBaseline = 'bottom';
    for (const minutes of [0, span / 2, span]) {
      context.fillText(minutes ? `−${minutes} min` : 'now', x(end - minutes * 60000), height);
    }
    context.save();
    context.beginPath();
    context.rect(left, 0, right - left, height);
    context.clip();
    this.drawDuty(context, shown, x, bottom, bottom - top);
    context.setLineDash([5, 4]);
    this.drawLine(context, shown, colour('ink'), sample => x(sample[0]), sample => sample[2] ? y(sample[2]) : null);
    context.setLineDash([]);
    context.lineWidth = 2;
    this.drawLine(context, shown, colour('heat'), sample => x(sample[0]), sample => y(sample[1]));
    context.restore();
    if (this.pointer !== null) this.drawReading(context, shown, x, y, width);
  }

  // In one piece between gaps.
  runs(samples) {
    const runs = [];
    samples.forEach((sample, i) => {
      if (i === 0 || sample[0] - samples[i - 1][0] > gapMs) runs.push([]);
      runs[runs.length - 1].push(sample);
    });
    return runs;
  }

  drawLine(context, samples, style, x, y) {
    context.strokeStyle = style;
    context.beginPath();
    for (const run of this.runs(samples)) {
      let drawn = false;
      for (const sample of run) {
        if (y(sample) === null) { drawn = false; continue; }
        if (drawn) context.lineTo(x(sample), y(sample)); else context.moveTo(x(sample), y(sample));
        drawn = true;
      }
    }
    context.stroke();
  }

  drawDuty(context, samples, x, bottom, height) {
    context.fillStyle = colour('duty');
    for (const run of this.runs(samples)) {
      context.beginPath();
      context.moveTo(x(run[0][0]), bottom);
      for (const sample of run) context.lineTo(x(sample[0]), bottom - height * (sample[3] || 0));
      context.lineTo(x(run[run.length - 1][0]), bottom);
      context.fill();
    }
  }

  drawReading(context, samples, x, y, width) {
    let nearest = null;
    for (const sample of samples) {
      if (!nearest || Math.abs(x(sample[0]) - this.pointer) < Math.abs(x(nearest[0]) - this.pointer)) nearest = sample;
    }
    if (!nearest) return;
    context.fillStyle = colour('ink');
    context.beginPath();
    context.arc(x(nearest[0]), y(nearest[1]), 3, 0, 2 * Math.PI);
    context.fill();
    context.textAlign = this.pointer < width / 2 ? 'left' : 'right';
    context.textBaseline = 'top';
    context.fillText(`${clockTime(nearest[0] - this.offset)}  ${nearest[1].toFixed(1)} °C  ${
      nearest[3] === null ? '' : `${(100 * nearest[3]).toFixed(0)} %`}`, this.pointer, 0);
  }
}
