/** Names and words for the required fields of a form that hold nothing; the first of them takes the focus. */
export function emptyFields(form: HTMLFormElement): Record<string, string> {
  const empty = [...form.querySelectorAll<HTMLInputElement>('input[required]')].filter(
    ({ value }) => value.trim() === '',
  )
  empty[0]?.focus()
  return Object.fromEntries(
    empty.map((field) => [field.name, `${field.labels?.[0]?.textContent?.trim() ?? 'This'} is required.`]),
  )
}
