// SPDX-License-Identifier: Apache-2.0
// Whether the part that the page draws as under way is where the printer says that its head is, by the points that
// the server has. The printer may have moved on between the two looks.
const done = arguments[0], canvas = document.querySelector('.card .path');
const layer = Number(canvas.dataset.layer), printed = Number(canvas.dataset.printed);
const job = Number(document.querySelector('#queue li').dataset.job);
const look = async () => {
  const {printers: [{position}]} = await (await fetch('/api/v1/state')).json();
  const head = await (await fetch(`/api/v1/jobs/${job}/path`)).json();
  const bytes = new DataView(await (await fetch(`/api/v1/jobs/${job}/path/${layer}`)).arrayBuffer());
  const place = i => [0, 2].map(offset => bytes.getInt16(8 * i + offset, true) * head.unit_mm);
  const at = [0, 1].map(axis => position.steps[axis] / head.steps_per_mm[axis]);
  const from = place(Math.max(0, printed - 1)), to = place(printed);
  const isWithin = axis => at[axis] >= Math.min(from[axis], to[axis]) - 0.5 && at[axis] <= Math.max(from[axis], to[axis]) + 0.5;
  return printed > 0 && isWithin(0) && isWithin(1);
};
look().then(done, () => done(false));
