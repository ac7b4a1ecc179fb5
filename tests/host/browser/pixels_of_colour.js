// SPDX-License-Identifier: Apache-2.0
// How many pixels of a canvas have this colour: arguments are a selector and the name of a colour of the page.
const canvas = document.querySelector(arguments[0]);
const [, red, green, blue] = colour(arguments[1]).match(/^#(..)(..)(..)$/).map(part => parseInt(part, 16));
const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
copy.drawImage(canvas, 0, 0);
const pixels = copy.getImageData(0, 0, canvas.width, canvas.height).data;
let count = 0;
for (let i = 0; i < pixels.length; i += 4) {
  if (pixels[i] === red && pixels[i + 1] === green && pixels[i + 2] === blue) ++count;
}
return count;
