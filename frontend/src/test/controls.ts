/** The controls of the page itself: those in rows of lists and tables come with what they are about. */
export function controlsInSight(main: HTMLElement): string[] {
  const controls = main.querySelectorAll<HTMLElement>('a[href], button, input, select, summary, textarea, [role="tab"]')
  return [...controls]
    .filter((control) => control.closest('li, tbody, article, [hidden], .visually-hidden') === null)
    .filter((control) => control.tagName === 'SUMMARY' || control.closest('details:not([open])') === null)
    .filter((control) => control.getAttribute('type') !== 'hidden' && !control.hidden)
    .map((control) => control.getAttribute('aria-label') ?? control.textContent?.trim() ?? '')
}
