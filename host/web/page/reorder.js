// SPDX-License-Identifier: Apache-2.0
// Another order of the jobs that wait: by a handle that is dragged with mouse, pen or finger, or by its
// arrow keys.
let dragged = null;  // {item, job}

// Before the job of this place among those that wait; behind all of them where there is none such.
async function moveJob(job, before, place, count) {
  if (await post(`/api/v1/jobs/${job.id}/move`, {before: before ? before.id : null})) {
    announce(`${job.name} is now number ${place + 1} of ${count} that wait`);
  }
}

function moveBy(job, waiting, step) {
  const place = waiting.findIndex(each => each.id === job.id), to = place + step;
  if (to < 0 || to >= waiting.length) {
    announce(`${job.name} is ${to < 0 ? 'first' : 'last'} already`);
    return;
  }
  moveJob(job, waiting[step < 0 ? to : to + 1], to, waiting.length);
}

const waitingItems = () => [...byId('queue').querySelectorAll('li.waits')];

function dragTo(y) {
  const others = waitingItems().filter(item => item !== dragged.item);
  const next = others.find(item => {
    const box = item.getBoundingClientRect();
    return y < box.top + box.height / 2;
  });
  if (next) next.before(dragged.item);
  else if (others.length) others[others.length - 1].after(dragged.item);
  if (y < 90) scrollBy(0, -12);
  if (y > innerHeight - 40) scrollBy(0, 12);
}

function endDrag(takes) {
  if (!dragged) return;
  const {item, job, waiting} = dragged;
  const items = waitingItems(), place = items.indexOf(item), next = items[place + 1];
  dragged = null;
  item.classList.remove('dragged');
  const stays = place === waiting.findIndex(each => each.id === job.id);
  if (takes && !stays) moveJob(job, next ? {id: Number(next.dataset.job)} : null, place, waiting.length);
  else showJobs();
}

function handleOf(item, job, waiting) {
  const handle = element('button', {type: 'button', className: 'handle', 'data-key': `${job.id} handle`,
    title: 'Drag, or use the arrow keys', 'aria-label': `Move ${nameOf(job)}: arrow keys, or drag`}, '⠿');
  handle.addEventListener('keydown', event => {
    const step = {ArrowUp: -1, ArrowDown: 1}[event.key];
    if (event.key === 'Escape') endDrag(false);
    if (!step) return;
    event.preventDefault();
    moveBy(job, waiting(), step);
  });
  handle.addEventListener('pointerdown', event => {
    if (event.button !== 0) return;
    event.preventDefault();
    handle.focus();
    dragged = {item, job, waiting: waiting()};
    item.classList.add('dragged');
  });
  return handle;
}
// Moved in the document the handle may lose the pointer, so the whole page listens.
addEventListener('pointermove', event => { if (dragged) dragTo(event.clientY); });
addEventListener('pointerup', () => endDrag(true));
addEventListener('pointercancel', () => endDrag(false));
addEventListener('keydown', event => { if (event.key === 'Escape') endDrag(false); });
