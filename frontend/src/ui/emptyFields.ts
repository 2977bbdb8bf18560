/** Names and words for the required fields of a form that hold nothing. */
export function emptyFields(form: HTMLFormElement | null): Record<string, string> {
  const required = form?.querySelectorAll<HTMLInputElement>('input[required], textarea[required], select[required]')
  const empty = [...(required ?? [])].filter(({ value }) => value.trim() === '')
  return Object.fromEntries(
    empty.map(({ dataset, name, type, labels }) => [
      dataset.path ?? name,
      type === 'date' ? 'Enter a date.' : `${labels?.[0]?.textContent?.trim() ?? 'This'} is required.`,
    ]),
  )
}
