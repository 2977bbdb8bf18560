// Sets light or dark before the first paint, so that the page never flashes.
;(() => {
  let kept
  try {
    kept = localStorage.getItem('soundlist-scheme')
  } catch {
    kept = null
  }
  const dark = kept === 'dark' || (kept !== 'light' && matchMedia('(prefers-color-scheme: dark)').matches)
  document.documentElement.setAttribute('data-mantine-color-scheme', dark ? 'dark' : 'light')
})()
