// SPDX-License-Identifier: Apache-2.0
// Light or dark: as the system, or as a person has chosen in this browser.
{
  const chosen = byId('theme');
  const apply = () => {
    if (chosen.value) document.documentElement.dataset.theme = chosen.value;
    else delete document.documentElement.dataset.theme;
    document.dispatchEvent(new Event('themechange'));
  };
  try { chosen.value = localStorage.getItem('theme') || ''; } catch { /* it keeps nothing */ }
  apply();
  chosen.addEventListener('change', () => {
    try { localStorage.setItem('theme', chosen.value); } catch { /* it keeps nothing */ }
    apply();
  });
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', apply);
}
