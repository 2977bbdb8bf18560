/**
 * Put text on the clipboard; the answer is whether it is there. Browsers open the clipboard to pages of HTTPS and of
 * localhost only: elsewhere a hidden field is selected and copied by the old command.
 */
export async function copyText(text: string, near: HTMLElement): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text) // there is no `clipboard` over plain HTTP
    return true
  } catch {
    return copySelected(text, near)
  }
}

/** The field stands beside the button: a dialog takes the focus back from anything outside of it. */
function copySelected(text: string, near: HTMLElement): boolean {
  const field = document.createElement('textarea')
  field.value = text
  field.readOnly = true
  field.className = 'visually-hidden'
  field.setAttribute('aria-hidden', 'true')
  near.after(field)
  field.focus({ preventScroll: true })
  field.select()
  try {
    return document.execCommand('copy')
  } catch {
    return false
  } finally {
    field.remove()
    near.focus()
  }
}
