/** Where in a TOML text something stands that the server names by its dotted place. */

const keysOf = (dotted: string): string[] =>
  (dotted.match(/"[^"]*"|'[^']*'|[^.\s]+/g) ?? []).map((key) => key.replace(/^["']|["']$/g, ''))

const begins = (whole: readonly string[], part: readonly string[]): boolean =>
  part.length > 0 && part.length <= whole.length && part.every((key, index) => key === whole[index])

/** The line of a place, counted from 1: its own, or that of the nearest table round it. */
export function lineOf(toml: string, place: string, message = ''): number | null {
  const match = /\(at line (\d+)/.exec(message)
  if (match) return Number(match[1])
  const keys = keysOf(place.replace(/\[\d+\]/g, ''))
  let table: string[] = []
  let best = { line: 0, length: 0 }
  toml.split('\n').forEach((text, index) => {
    const head = /^\s*\[+([^\]]+)\]+/.exec(text)
    if (head) table = keysOf(head[1] ?? '')
    const key = head ? null : /^\s*((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=/.exec(text)
    const path = key ? [...table, ...keysOf(key[1] ?? '')] : head ? table : []
    if (begins(keys, path) && path.length > best.length) best = { line: index + 1, length: path.length }
  })
  return best.line === 0 ? null : best.line
}

export interface Correction {
  label: string
  toml: string
}

/** The text with the nearest known word in place of the one that is not known. */
export function correctionOf(toml: string, place: string, message: string): Correction | null {
  const nearest = /the nearest known is "([^"]+)"/.exec(message)?.[1]
  const line = lineOf(toml, place, message)
  if (nearest === undefined || line === null) return null
  const isKey = message.startsWith('unknown key')
  const wrong = isKey ? place.split('.').at(-1) : /found "([^"]+)"/.exec(message)?.[1]
  const lines = toml.split('\n')
  const text = lines[line - 1] ?? ''
  if (wrong === undefined) return null
  const at = isKey ? text.indexOf(wrong) : text.lastIndexOf(wrong)
  if (at < 0) return null
  lines[line - 1] = text.slice(0, at) + nearest + text.slice(at + wrong.length)
  return { label: `Use ${nearest}`, toml: lines.join('\n') }
}

/** Whether the text has words that a form would not keep. */
export const hasComments = (toml: string): boolean =>
  toml.split('\n').some((line) => /^\s*#/.test(line) || /\s#/.test(line.replace(/"[^"]*"|'[^']*'/g, '')))
