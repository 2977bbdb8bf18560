/** Whether a whole name fits a pattern; null where this browser cannot try it, as its expressions differ a little. */
export function fits(pattern: string, name: string): boolean | null {
  if (pattern === '' || pattern === 'any') return true
  try {
    return new RegExp(`^(?:${pattern})$`).test(name)
  } catch {
    return null
  }
}
