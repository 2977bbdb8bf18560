const LONGEST_PATTERN = 200
const MAX_NAME_CHARS = 100
const MAX_REPEATS = 3 // without an end, one after the other: the search takes the length to this power

/**
 * Whether a browser's search through names is sure to be quick: no repeated group repeats anything inside, but for a
 * separator and letters, as in `(_[a-z0-9]+)*`. The server matches every pattern in linear time; browsers do not.
 */
function isQuick(pattern: string): boolean {
  if (pattern.length > LONGEST_PATTERN) return false
  const plain = pattern.replaceAll(/\((?:\?:)?[_ -]\[(?:[A-Za-z0-9]-[A-Za-z0-9]|[A-Za-z0-9])+\][+*]?\)[+*?]/g, '')
  if (/\)(?:[*+]|\{)/.test(plain)) return false
  return (plain.match(/[*+]|\{\d*,/g) ?? []).length <= MAX_REPEATS
}

/** Whether a whole name fits a pattern; null where it is not tried here, and is judged by the server when saved. */
export function fits(pattern: string, name: string): boolean | null {
  if (pattern === '' || pattern === 'any') return true
  if (!isQuick(pattern) || name.length > MAX_NAME_CHARS) return null
  try {
    return new RegExp(`^(?:${pattern})$`).test(name)
  } catch {
    return null
  }
}
