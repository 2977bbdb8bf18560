/** The tables of a spec as its TOML keys them; where something stands is written "limits.true_peak_dbtp". */
export type Tables = Record<string, unknown>

const isTables = (value: unknown): value is Tables =>
  typeof value === 'object' && value !== null && !Array.isArray(value)

/** A table within tables; nothing where there is none. */
export const tableIn = (value: unknown): Tables => (isTables(value) ? value : {})

export function at(tables: Tables, place: readonly string[]): unknown {
  return place.reduce<unknown>((value, key) => (isTables(value) ? value[key] : undefined), tables)
}

/** The tables with one value changed; undefined takes the key away, and a table that this empties with it. */
export function put(tables: Tables, place: readonly string[], value: unknown, keepEmpty = false): Tables {
  const [key, ...rest] = place
  if (key === undefined) return tables
  const { [key]: old, ...others } = tables
  const next = rest.length === 0 ? value : put(tableIn(old), rest, value, keepEmpty)
  const goes = next === undefined || (rest.length > 0 && !keepEmpty && isTables(next) && Object.keys(next).length === 0)
  if (goes) return others
  return key in tables ? { ...tables, [key]: next } : { ...others, [key]: next }
}

/** The tables with a key called otherwise, in its old place. */
export function rename(tables: Tables, from: string, to: string): Tables {
  return Object.fromEntries(Object.entries(tables).map(([key, value]) => [key === from ? to : key, value]))
}

/** Whether two tables say the same, in whatever order. */
export function same(a: unknown, b: unknown): boolean {
  if (isTables(a) && isTables(b)) {
    const names = new Set([...Object.keys(a), ...Object.keys(b)])
    return [...names].every((name) => same(a[name], b[name]))
  }
  if (Array.isArray(a) && Array.isArray(b)) {
    return a.length === b.length && a.every((value, index) => same(value, b[index]))
  }
  return a === b
}

/** A number as typed; other text stays as typed, so that it is reported and not lost. */
export function typedNumber(text: string): number | string | undefined {
  const plain = text
    .trim()
    .replace('−', '-')
    .replace(/^(-?\d*),(\d+)$/, '$1.$2')
  if (plain === '') return undefined
  return /^[+-]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : plain
}
