// SPDX-License-Identifier: Apache-2.0
// WCAG 2.2, 1.4.3: 4.5 for text, 3 for large text. Of every element with text of its own against what is painted
// behind it; returns those with less.
const parse = text => {
  const [r, g, b, a = 1] = text.match(/[\d.]+/g).map(Number);
  return {r, g, b, a};
};
const over = (top, below) => {
  const mixed = name => top[name] * top.a + below[name] * (1 - top.a);
  return {r: mixed('r'), g: mixed('g'), b: mixed('b'), a: 1};
};
const linear = value => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
const luminance = ({r, g, b}) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
const behind = node => {
  const layers = [];
  for (let each = node; each; each = each.parentElement) layers.unshift(parse(getComputedStyle(each).backgroundColor));
  return layers.reduce((below, top) => over(top, below), {r: 255, g: 255, b: 255, a: 1});
};
const bad = [];
for (const node of document.querySelectorAll('body *')) {
  const own = [...node.childNodes].some(child => child.nodeType === 3 && child.textContent.trim());
  const isField = node.matches('input:not([type=checkbox], [type=range], [type=file]), select');
  if (!(own || isField) || !node.checkVisibility() || node.disabled || node.closest('.unseen, option')) continue;
  const style = getComputedStyle(node), back = behind(node);
  const [light, dark] = [luminance(over(parse(style.color), back)), luminance(back)].sort((x, y) => y - x);
  const size = parseFloat(style.fontSize), isLarge = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
  const ratio = (light + 0.05) / (dark + 0.05);
  if (ratio < (isLarge ? 3 : 4.5)) bad.push(`${node.tagName} "${node.textContent.slice(0, 30)}" ${ratio.toFixed(2)}`);
}
return bad;
