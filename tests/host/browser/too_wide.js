// SPDX-License-Identifier: Apache-2.0
// What reaches beyond the right edge of the window.
return [...document.querySelectorAll('body *')]
  .filter(each => each.checkVisibility() && !each.closest('.unseen, .skip'))
  .filter(each => each.getBoundingClientRect().right > innerWidth + 0.5)
  .map(each => `${each.tagName} ${each.className}`);
