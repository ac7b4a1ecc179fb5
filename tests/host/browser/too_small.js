// SPDX-License-Identifier: Apache-2.0
// Controls that are lower than a finger needs (WCAG 2.2, 2.5.8: 24 pixels). A checkbox has its label.
return [...document.querySelectorAll('button, select, summary, input')]
  .filter(each => each.checkVisibility() && each.type !== 'checkbox' && each.getBoundingClientRect().height < 24)
  .map(each => each.outerHTML);
