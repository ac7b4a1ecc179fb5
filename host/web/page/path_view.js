// SPDX-License-Identifier: Apache-2.0
// A layer of a job's path, with what is printed of it and where the head is.
class PathView {
  constructor(name) {
    this.name = name;
    this.path = this.asked = this.part = this.head = this.points = this.below = null;
    this.shown = 0;
    this.canvas = element('canvas', {className: 'path', role: 'img'});
    this.slider = element('input', {type: 'range', min: 1, max: 1, value: 1, 'aria-label': `Layer of ${name}`});
    this.follow = element('input', {type: 'checkbox', checked: true});
    this.words = element('p', {className: 'what'});
    this.followLabel = element('label', {}, this.follow, ' follow the print');
    this.box = element('div', {className: 'path-box', hidden: true}, this.canvas,
      element('div', {className: 'path-controls'}, this.slider, this.followLabel), this.words);
    this.redraw = sharpCanvas(this.canvas, (context, width, height) => this.draw(context, width, height));
    this.slider.addEventListener('input', () => { this.follow.checked = false; this.select(this.slider.value - 1); });
    this.follow.addEventListener('change', () => this.followPrint());
  }

  // Of this job, or of none. What is under way is not known yet.
  async load(job) {
    const id = job && job.has_path ? job.id : null;
    if (this.asked === id) return;
    this.asked = id;
    this.path = this.part = this.head = null;
    this.box.hidden = true;
    const path = id === null ? null : await PathData.of(id);
    if (this.asked !== id) return;  // another one has been asked for meanwhile
    if (!path) return;
    this.path = path;
    this.slider.max = path.layers.length;
    this.box.hidden = false;
    await this.select(0);
  }

  // What could not be read is read again.
  retry() { if (!this.path) this.asked = null; }

  // Of a print: commands that the printer has taken, and its last report of a position.
  async progress(done, position) {
    const path = this.path;
    if (!path) return;
    const turn = this.turn = (this.turn || 0) + 1;
    const part = await partUnderWay(path, done, position, this.part);
    if (this.path !== path || this.turn !== turn) return;  // the next report was faster
    if (part) this.part = part;
    this.head = position ? path.placeOf(position) : null;
    this.followPrint();
  }

  followPrint() {
    if (this.follow.checked && this.part && this.part.layer !== this.shown) this.select(this.part.layer);
    else this.tell();
  }

  async select(index) {
    const path = this.path;
    if (!path) return;
    this.shown = index;
    const [points, below] = await Promise.all([path.layer(index), path.layer(index - 1)]);
    if (this.path !== path || this.shown !== index) return;
    Object.assign(this, {points, below});
    this.slider.value = index + 1;
    this.tell();
  }

  // How many points of the shown layer are printed.
  printed() {
    if (!this.part || !this.points || this.shown > this.part.layer) return 0;
    return this.shown < this.part.layer ? this.points.x.length : this.part.point;
  }

  headWords() {
    const [x, y, z] = this.head;
    return `X\u00a0${x.toFixed(1)} Y\u00a0${y.toFixed(1)} Z\u00a0${z.toFixed(2)}\u00a0mm`;
  }

  tell() {
    const layer = this.path.layers[this.shown];
    const share = this.points ? Math.round(100 * this.printed() / Math.max(1, this.points.x.length - 1)) : 0;
    const words = `layer ${this.shown + 1} of ${this.path.layers.length}, Z ${layer.z.toFixed(2)} mm` +
      (this.followLabel.hidden ? '' : `, ${Math.min(100, share)} % of it printed`) +
      (this.head ? `. Head at ${this.headWords()}` : '');
    setText(this.words, words);
    this.slider.setAttribute('aria-valuetext', `${this.shown + 1} of ${this.path.layers.length}`);
    this.canvas.setAttribute('aria-label', `Path of ${this.name}: ${words}`);
    Object.assign(this.canvas.dataset, {printed: this.printed(), layer: this.shown});
    this.redraw();
  }

  draw(context, width, height) {
    if (!this.path || !this.points) return;
    const [left, low, right, high] = this.path.bounds, margin = 10;
    const scale = Math.min((width - 2 * margin) / Math.max(right - left, 1), (height - 2 * margin) / Math.max(high - low, 1));
    const x = value => width / 2 + (value - (left + right) / 2) * scale;
    const y = value => height / 2 - (value - (low + high) / 2) * scale;
    context.lineJoin = context.lineCap = 'round';
    const stroke = (points, from, to, extrudes, style, line) => {
      context.strokeStyle = style;
      context.lineWidth = line;
      context.beginPath();
      for (let i = from; i < to; ++i) {
        if (points.extrudes[i] !== extrudes) continue;
        if (i === from || points.extrudes[i - 1] !== extrudes) context.moveTo(x(points.x[i - 1]), y(points.y[i - 1]));
        context.lineTo(x(points.x[i]), y(points.y[i]));
      }
      context.stroke();
    };
    const end = this.points.x.length, printed = Math.max(1, this.printed());
    if (this.below) stroke(this.below, 1, this.below.x.length, 1, colour('line'), 1);
    stroke(this.points, printed, end, 0, colour('line'), 1);
    stroke(this.points, printed, end, 1, colour('quiet'), 1);
    stroke(this.points, 1, printed, 1, colour('accent'), 2.5);
    if (this.part && this.shown === this.part.layer && this.points.extrudes[this.part.point]) {
      const i = this.part.point, share = this.part.share;
      context.beginPath();
      context.moveTo(x(this.points.x[i - 1]), y(this.points.y[i - 1]));
      context.lineTo(x(this.points.x[i - 1] + share * (this.points.x[i] - this.points.x[i - 1])),
        y(this.points.y[i - 1] + share * (this.points.y[i] - this.points.y[i - 1])));
      context.stroke();
    }
    if (!this.head) return;
    context.fillStyle = colour('bad');
    context.strokeStyle = colour('card');
    context.lineWidth = 2;
    context.beginPath();
    context.arc(x(this.head[0]), y(this.head[1]), 5, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  }
}
