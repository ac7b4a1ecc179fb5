// SPDX-License-Identifier: Apache-2.0
// A course over time on a canvas: ranges of buckets, lines of samples, limits, marks, and a cursor.
const span = {
  t0 : 0,
  t1 : endOfPrint
};  // what all charts show
const charts = [];
const margin = {
  left : 50,
  right : 10,
  top : 8,
  bottom : 20
};

class Chart {
  // series: { label, tint, range | t + values, digits, dashed }; limits: { value, dashed };
  // marks: [[t, tint]]; unit, height, low, high: what is shown at least.
  constructor(holder, spec) {
    Object.assign(
        this, {series : [], limits : [], marks : [], unit : '', height : 120, low : 0, high : 1},
        spec);
    const box = element('div', {class : 'chart'});
    if (this.title) box.append(element('h3', {}, this.title));
    this.key = element('div', {class : 'key'});
    for (const series of this.series) {
      const swatch = element(
          'i', {style : `background:var(--${series.tint})${series.dashed ? ';opacity:.5' : ''}`});
      series.out = element('b');
      this.key.append(element('span', {}, swatch, series.label, series.out));
    }
    this.canvas = element('canvas', {
      role : 'img',
      'aria-label' : this.title || this.series[0].label,
      style : `height:${this.height}px`
    });
    box.append(this.key, this.canvas);
    document.getElementById(holder).append(box);
    charts.push(this);
  }

  x(t) { return margin.left + (t - span.t0) / (span.t1 - span.t0) * this.plotWidth; }
  y(value) { return margin.top + (this.top - value) / (this.top - this.bottom) * this.plotHeight; }
  timeAt(x) {
    const part = (x - margin.left) / this.plotWidth;
    return span.t0 + Math.min(1, Math.max(0, part)) * (span.t1 - span.t0);
  }

  // One point (x, lowest, highest) for each column of pixels or each bucket, whichever is wider.
  // NaN lifts the pen.
  columns(series) {
    const points = [];
    const put = (t, low, high) => {
      const x = this.x(t), last = points[points.length - 1];
      if (last && low === low && last.low === last.low && Math.floor(last.x) === Math.floor(x)) {
        last.low = Math.min(last.low, low);
        last.high = Math.max(last.high, high);
      } else {
        points.push({x, low, high});
      }
    };
    if (series.range) {
      const {dt, low, high, n} = series.range;
      const first = Math.max(0, Math.floor(span.t0 / dt) - 1),
            end = Math.min(n - 1, Math.ceil(span.t1 / dt) + 1);
      for (let i = first; i <= end; ++i) put((i + 0.5) * dt, low[i], high[i]);
    } else {
      const first = Math.max(0, indexAt(series.t, span.t0) - 1);
      for (let i = first; i < series.t.length; ++i) {
        put(series.t[i], series.values[i], series.values[i]);
        if (series.t[i] > span.t1) break;
      }
    }
    return points;
  }

  draw() {
    const {context, width, height} = sharpContext(this.canvas, this.height);
    if (width <= margin.left + margin.right) return;  // hidden
    this.plotWidth = width - margin.left - margin.right;
    this.plotHeight = height - margin.top - margin.bottom;
    const drawn = this.series.map((series) => this.columns(series));
    this.findHeights(drawn);
    this.drawAxes(context, width, height);
    context.save();
    context.beginPath();
    context.rect(margin.left, 0, this.plotWidth, height - margin.bottom + 1);
    context.clip();
    drawn.forEach((points, i) => this.drawSeries(context, points, this.series[i]));
    this.drawLimits(context, width);
    for (const [t, tint] of this.marks) this.upright(context, t, colour(tint), 1.5, []);
    this.upright(context, view.t, colour('text'), 1, [ 3, 3 ]);
    context.restore();
    this.showValues();
  }

  findHeights(drawn) {
    this.bottom = this.low;
    this.top = this.high;
    for (const points of drawn) {
      for (const point of points) {
        if (point.x < margin.left || point.x > margin.left + this.plotWidth) continue;
        if (point.low < this.bottom) this.bottom = point.low;
        if (point.high > this.top) this.top = point.high;
      }
    }
    for (const limit of this.limits) {
      this.top = Math.max(this.top, limit.value);
      this.bottom = Math.min(this.bottom, limit.value);
    }
    const room = 0.06 * (this.top - this.bottom);
    this.top += room;
    if (this.bottom < 0) this.bottom -= room;
  }

  drawAxes(context, width, height) {
    const step = niceStep(this.top - this.bottom, this.plotHeight / 22), digits = digitsFor(step);
    context.lineWidth = 1;
    context.strokeStyle = colour('grid');
    context.fillStyle = colour('dim');
    context.textAlign = 'right';
    for (let value = Math.ceil(this.bottom / step) * step; value <= this.top; value += step) {
      const y = this.y(value);
      context.beginPath();
      context.moveTo(margin.left, y);
      context.lineTo(width - margin.right, y);
      context.stroke();
      context.fillText(
          number(Math.abs(value) < step / 1e3 ? 0 : value, digits), margin.left - 6, y + 4);
    }
    context.textAlign = 'center';
    const tick = niceTimeStep(span.t1 - span.t0, this.plotWidth / 75);
    for (let t = Math.ceil(span.t0 / tick) * tick; t <= span.t1; t += tick) {
      const x = this.x(t);
      context.beginPath();
      context.moveTo(x, margin.top);
      context.lineTo(x, height - margin.bottom);
      context.stroke();
      context.fillText(timeText(t, digitsFor(tick)), Math.min(x, width - 18), height - 5);
    }
    context.textAlign = 'left';
  }

  drawSeries(context, points, series) {
    if (points.length === 0) return;
    context.strokeStyle = context.fillStyle = colour(series.tint);
    context.lineWidth = series.dashed ? 1.2 : 1.6;
    context.setLineDash(series.dashed ? [ 5, 4 ] : []);
    context.lineJoin = 'round';
    context.beginPath();
    points.forEach((point, i) => {
      const lifted =
          i === 0 || point.high !== point.high || points[i - 1].high !== points[i - 1].high;
      context[lifted ? 'moveTo' : 'lineTo'](point.x, this.y(point.high || 0));
    });
    if (points.some((point) => point.high > point.low)) {
      for (let i = points.length - 1; i >= 0; --i)
        context.lineTo(points[i].x, this.y(points[i].low));
      context.closePath();
      context.globalAlpha = 0.45;
      context.fill();
      context.globalAlpha = 1;
      context.lineWidth = 1;
    }
    context.stroke();
    context.setLineDash([]);
  }

  drawLimits(context, width) {
    context.strokeStyle = context.fillStyle = colour('bad');
    context.lineWidth = 1.2;
    for (const limit of this.limits) {
      context.setLineDash(limit.dashed ? [ 2, 4 ] : [ 8, 4 ]);
      context.beginPath();
      context.moveTo(margin.left, this.y(limit.value));
      context.lineTo(width - margin.right, this.y(limit.value));
      context.stroke();
    }
    context.setLineDash([]);
  }

  upright(context, t, tint, thick, dash) {
    const x = this.x(t);
    context.strokeStyle = tint;
    context.lineWidth = thick;
    context.setLineDash(dash);
    context.beginPath();
    context.moveTo(x, margin.top - 4);
    context.lineTo(x, margin.top + this.plotHeight);
    context.stroke();
    context.setLineDash([]);
  }

  showValues() {
    for (const series of this.series) {
      const digits = series.digits ?? 1;
      let words = '';
      if (series.range && series.range.n > 0) {
        const {dt, low, high, n} = series.range, i = Math.min(n - 1, Math.floor(view.t / dt));
        const from = number(low[i], digits), to = number(high[i], digits);
        words = from === to ? to : `${from} to ${to}`;
      } else if (series.t && series.t.length > 0) {
        const value = series.values[indexAt(series.t, view.t)];
        words = value === value ? number(value, digits) : '';
      }
      series.out.textContent = words && `${words} ${this.unit}`;
    }
  }
}
