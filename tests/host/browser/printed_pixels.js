// SPDX-License-Identifier: Apache-2.0
// So many pixels of the path have the colour of what is printed, in the light theme.
const canvas = document.querySelector('.card .path');
const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
let count = 0;
for (let i = 0; i < pixels.length; i += 4) {
  if (pixels[i] === 0x0b && pixels[i + 1] === 0x57 && pixels[i + 2] === 0xc2) ++count;
}
return count;
