// SPDX-License-Identifier: Apache-2.0
// Files into the queue, by the field or dropped anywhere on the page.

// XMLHttpRequest, because fetch reports no progress of an upload.
function upload(file) {
  return new Promise(done => {
    const form = new FormData();
    form.append('print', String(!byId('held').checked));
    form.append('file', file);
    const sending = new XMLHttpRequest();
    const wanted = byId('wanted').value;
    sending.open('POST', '/api/v1/jobs' + (wanted ? `?printer=${encodeURIComponent(wanted)}` : ''));
    if (key) sending.setRequestHeader('X-Api-Key', key);
    sending.upload.onprogress = event => { byId('upload').value = event.loaded / Math.max(1, event.total); };
    sending.onloadend = () => {
      if (sending.status === 201) {
        announce(`${file.name} is in the queue`);
        return done();
      }
      let why = 'the server does not answer; drop it again when it is there';
      try { why = JSON.parse(sending.responseText).error; } catch { /* it is no JSON */ }
      show(`${file.name} was not taken: ${why}`);
      done();
    };
    sending.send(form);
  });
}

let uploading = Promise.resolve();
function uploadAll(files) {
  uploading = uploading.then(async () => {
    show('');
    byId('upload').hidden = false;
    for (const file of files) {
      byId('upload').value = 0;
      byId('upload').setAttribute('aria-label', `Upload of ${file.name}`);
      await upload(file);
    }
    byId('upload').hidden = true;
  });
  return uploading;
}

byId('files').addEventListener('change', async event => {
  await uploadAll([...event.target.files]);
  event.target.value = '';
});
const hasFiles = event => event.dataTransfer && [...event.dataTransfer.types].includes('Files');
addEventListener('dragover', event => {
  if (!hasFiles(event)) return;
  event.preventDefault();
  byId('drop').classList.add('over');
});
addEventListener('dragleave', event => { if (!event.relatedTarget) byId('drop').classList.remove('over'); });
addEventListener('drop', event => {
  if (!hasFiles(event)) return;
  event.preventDefault();
  byId('drop').classList.remove('over');
  uploadAll([...event.dataTransfer.files]);
});

function showWanted(printers) {
  const select = byId('wanted'), chosen = select.value;
  const names = printers.map(printer => printer.name);
  if ([...select.options].slice(1).map(option => option.value).join() === names.join()) return;
  select.replaceChildren(select.options[0], ...names.map(name => element('option', {value: name}, name)));
  select.value = names.includes(chosen) ? chosen : '';
}
