// SPDX-License-Identifier: Apache-2.0
// Moving, zooming and turning the path with mouse, wheel and fingers; words about what is under the
// pointer.
const tip = document.getElementById('path-tip');
const pointers = new Map();

function placeOf(event) {
  const box = pathCanvas.getBoundingClientRect();
  return {x : event.clientX - box.left, y : event.clientY - box.top};
}

function zoomPath(factor, at) {
  const x = at.x - pathCanvas.clientWidth / 2, y = pathCanvas.clientHeight / 2 - at.y;
  view.u += x / view.scale;
  view.v += y / view.scale;
  view.scale = Math.min(20000, Math.max(0.2, view.scale * factor));
  view.u -= x / view.scale;
  view.v -= y / view.scale;
  drawPath();
}

function movePath(dx, dy) {
  view.u -= dx / view.scale;
  view.v += dy / view.scale;
  drawPath();
}

function turnPath(dx, dy) {
  view.azimuth += dx * 0.008;
  view.elevation = Math.min(Math.PI / 2, Math.max(0, view.elevation + dy * 0.008));
  drawPath();
}

pathCanvas.addEventListener('wheel', (event) => {
  event.preventDefault();
  zoomPath(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), placeOf(event));
}, {passive : false});

pathCanvas.addEventListener('pointerdown', (event) => {
  pointers.set(event.pointerId, placeOf(event));
  pathCanvas.setPointerCapture(event.pointerId);
});

pathCanvas.addEventListener('pointermove', (event) => {
  const now = placeOf(event), before = pointers.get(event.pointerId);
  if (!before) {
    describe(now);
    return;
  }
  tip.style.display = 'none';
  if (pointers.size === 1) {
    (view.inSpace && !event.shiftKey ? turnPath : movePath)(now.x - before.x, now.y - before.y);
  } else {
    const other = [...pointers ].find(([ id ]) => id !== event.pointerId)[1];
    const reach = (point) => Math.max(8, Math.hypot(point.x - other.x, point.y - other.y));
    movePath((now.x - before.x) / 2, (now.y - before.y) / 2);
    zoomPath(reach(now) / reach(before), {x : (now.x + other.x) / 2, y : (now.y + other.y) / 2});
  }
  pointers.set(event.pointerId, now);
});

for (const name of ['pointerup', 'pointercancel']) {
  pathCanvas.addEventListener(name, (event) => {
    pointers.delete(event.pointerId);
    if (name === 'pointerup') describe(placeOf(event));
  });
}
pathCanvas.addEventListener('pointerleave', () => {
  tip.style.display = 'none';
});

function nearest(count, placeAt, at, reach) {
  let best = -1, distance = reach;
  for (let i = 0; i < count; ++i) {
    const place = placeAt(i);
    if (!place) continue;
    const away = Math.hypot(place[0] - at.x, place[1] - at.y);
    if (away < distance) {
      best = i;
      distance = away;
    }
  }
  return best;
}

// The missed point under the pointer, or else the end of a line of the file near to it.
function describe(at) {
  const missed = nearest(data.missed.length, (i) => {
    const point = data.missed[i];
    return onScreen(point.x, point.y, point.z);
  }, at, 12);
  const z = layers.length ? layers[view.layer].z : 0;
  const end = missed >= 0 ?
      -1 :
      nearest(
          asked.n,
          (i) => asked.kind[i] === '0' || (view.oneLayer && Math.abs(asked.z[i] - z) > sameLayer) ?
              null :
              onScreen(asked.x[i], asked.y[i], asked.z[i]),
          at, 10);
  let words = '';
  if (missed >= 0) {
    words = data.missed[missed].words;
  } else if (end >= 0) {
    words = `line ${asked.fileLine[end]}${asked.kind[end] === '3' ? ' (refused)' : ''}\nX ${
        number(asked.x[end], 3)}  Y ${number(asked.y[end], 3)}  Z ${number(asked.z[end], 3)}`;
  }
  tip.style.display = words ? 'block' : 'none';
  if (words) {
    tip.textContent = words;
    const right = at.x > pathCanvas.clientWidth / 2;
    tip.style.left = right ? 'auto' : `${at.x + 14}px`;
    tip.style.right = right ? `${pathCanvas.clientWidth - at.x + 14}px` : 'auto';
    tip.style.top = `${Math.max(0, at.y - 20)}px`;
  }
}

// Two places with a few millimetres around them.
function lookAt([ x0, y0, z0, x1, y1, z1 ]) {
  const [u0, v0] = projected(x0, y0, z0), [ u1, v1 ] = projected(x1, y1, z1), around_mm = 4;
  view.u = (u0 + u1) / 2;
  view.v = (v0 + v1) / 2;
  view.scale = Math.min(
      pathCanvas.clientWidth / (Math.abs(u1 - u0) * 1.2 + around_mm),
      pathCanvas.clientHeight / (Math.abs(v1 - v0) * 1.2 + around_mm));
  drawPath();
}
