/** A sentence of the server as the screens write it: a capital first, a true minus before figures, an end. */
export function sentence(text: string): string {
  const written = text.replace(/(^|[\s(])-(?=\d|∞|inf)/g, '$1−')
  const begun = written.charAt(0).toUpperCase() + written.slice(1)
  return /[.?!…]$/.test(begun) ? begun : `${begun}.`
}
