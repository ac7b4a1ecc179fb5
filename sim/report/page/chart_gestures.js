// SPDX-License-Identifier: Apache-2.0
// Choosing a time and a span of time in the charts; all charts follow.
function showSpan(t0, t1) {
  const shortest = Math.min(0.02, endOfPrint);
  const middle = (t0 + t1) / 2, half = Math.max(shortest, t1 - t0) / 2;
  span.t0 = Math.max(0, Math.min(middle - half, endOfPrint - 2 * half));
  span.t1 = Math.min(endOfPrint, span.t0 + 2 * half);
  drawCharts();
}
function zoomSpan(factor, t) { showSpan(t - (t - span.t0) * factor, t + (span.t1 - t) * factor); }

function listenTo(chart) {
  const canvas = chart.canvas;
  const fingers = new Map();
  let from = null;  // where a mouse button went down
  const place = (event) => event.clientX - canvas.getBoundingClientRect().left;

  canvas.addEventListener('pointerdown', (event) => {
    fingers.set(event.pointerId, place(event));
    canvas.setPointerCapture(event.pointerId);
    if (event.pointerType === 'mouse') from = place(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!fingers.has(event.pointerId)) return;
    const x = place(event);
    if (fingers.size === 2) {
      const other = [...fingers ].find(([ id ]) => id !== event.pointerId)[1];
      const before = Math.max(8, Math.abs(fingers.get(event.pointerId) - other));
      zoomSpan(before / Math.max(8, Math.abs(x - other)), chart.timeAt((x + other) / 2));
    } else if (event.pointerType !== 'mouse') {
      setTime(chart.timeAt(x));
    } else if (Math.abs(x - from) > 3) {
      drawCharts();
      const {context, height} = {context : canvas.getContext('2d'), height : chart.height};
      context.fillStyle = colour('accent');
      context.globalAlpha = 0.2;
      context.fillRect(Math.min(x, from), 0, Math.abs(x - from), height);
      context.globalAlpha = 1;
    }
    fingers.set(event.pointerId, x);
  });
  const end = (event) => {
    const x = place(event);
    fingers.delete(event.pointerId);
    if (event.type === 'pointerup' && event.pointerType === 'mouse' && from !== null &&
        Math.abs(x - from) > 3) {
      showSpan(chart.timeAt(Math.min(x, from)), chart.timeAt(Math.max(x, from)));
    } else if (event.type === 'pointerup' && fingers.size === 0) {
      setTime(chart.timeAt(x));
    }
    from = null;
  };
  canvas.addEventListener('pointerup', end);
  canvas.addEventListener('pointercancel', end);
  canvas.addEventListener('dblclick', () => showSpan(0, endOfPrint));
  canvas.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && !event.shiftKey) return;  // the page scrolls
    event.preventDefault();
    zoomSpan(Math.exp((event.deltaY || event.deltaX) * 0.002), chart.timeAt(place(event)));
  }, {passive : false});
}
