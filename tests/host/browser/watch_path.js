// SPDX-License-Identifier: Apache-2.0
// Notes each change of what the page draws as printed: points since the first layer began. Layers have the
// same number of points, the argument.
const pointsOfLayer = arguments[0];
window.seen = [];
setInterval(() => {
  const part = cards.get('simulated').view.part;
  if (!part) return;
  const points = pointsOfLayer * part.layer + part.point;
  if (seen[seen.length - 1] !== points) seen.push(points);
}, 20);
