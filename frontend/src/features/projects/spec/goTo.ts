/** Focus the field of the form where something is wrong. */
export function goTo(place: string) {
  const keys = place.replace(/\[\d+\]/g, '').split('.')
  for (let count = keys.length; count > 0; count -= 1) {
    const field = document.getElementById(`spec-${keys.slice(0, count).join('.')}`)
    if (field) {
      field.scrollIntoView({ block: 'center' })
      const target = field.matches('input, textarea, button')
        ? field
        : field.querySelector<HTMLElement>('button, input')
      target?.focus()
      return
    }
  }
}

/** Put the caret into a line of the text. */
export function goToLine(toml: string, line: number) {
  const field = document.getElementById('spec-toml')
  if (!(field instanceof HTMLTextAreaElement)) return
  const lines = toml.split('\n')
  const start = lines.slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0)
  field.focus({ preventScroll: true })
  field.setSelectionRange(start, start + (lines[line - 1]?.length ?? 0))
  const top = field.getBoundingClientRect().top + window.scrollY
  window.scrollTo({ top: top + (line / lines.length) * field.offsetHeight - window.innerHeight / 2 })
}
