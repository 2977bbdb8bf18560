/** How file names are built: parts in their order, and what stands between them. */
export interface Token {
  name: string
  case?: 'lower' | 'upper' | 'capital' | 'any'
  digits?: number
  one_of?: string[]
  optional?: boolean
  repeats?: boolean
}

export interface Naming {
  tokens: Token[]
  separator: string
  extension: string
}

const isRecord = (value: unknown): value is Record<string, unknown> => typeof value === 'object' && value !== null

export const NO_NAMING: Naming = { tokens: [], separator: '_', extension: '.wav' }

/** The parts that can be clicked. */
export const OFFERED: readonly Token[] = [
  { name: 'category', case: 'lower' },
  { name: 'what', case: 'lower' },
  { name: 'detail', case: 'lower', repeats: true, optional: true },
  { name: 'language', one_of: ['en', 'de', 'fr', 'es', 'ja'] },
  { name: 'variation', digits: 2, optional: true },
]

export function namingOf(value: unknown): Naming {
  if (!isRecord(value) || !Array.isArray(value.tokens)) return NO_NAMING
  return {
    tokens: value.tokens.filter(isRecord) as unknown as Token[],
    separator: typeof value.separator === 'string' ? value.separator : '_',
    extension: typeof value.extension === 'string' ? value.extension : '.wav',
  }
}

const LETTERS = { lower: '[a-z0-9]+', upper: '[A-Z0-9]+', capital: '[A-Z0-9][A-Za-z0-9]*', any: '[A-Za-z0-9]+' }

const fitsToken = (token: Token, part: string): boolean => {
  if (token.one_of) return token.one_of.includes(part)
  if (token.digits !== undefined) return part.length === token.digits && /^\d+$/.test(part)
  return new RegExp(`^${LETTERS[token.case ?? 'lower']}$`).test(part)
}

/** Which token each part of a name is; null where the name does not fit. Tried like the server does, part by part. */
export function readName(naming: Naming, fileName: string): Token[] | null {
  const { tokens, separator, extension } = naming
  const stem = fileName.endsWith(extension) ? fileName.slice(0, -extension.length) : fileName
  const parts = stem.split(separator)
  const known = new Map<string, Token[] | null>()
  const from = (read: number, done: number): Token[] | null => {
    if (read === parts.length && done === tokens.length) return []
    const place = `${read} ${done}`
    const before = known.get(place)
    if (before !== undefined) return before
    known.set(place, null)
    const token = tokens[done]
    let matched: Token[] | null = null
    if (token) {
      const part = parts[read]
      if (part !== undefined && fitsToken(token, part)) {
        const rest = from(read + 1, done + 1) ?? (token.repeats ? from(read + 1, done) : null)
        if (rest) matched = [token, ...rest]
      }
      if (!matched && token.optional) matched = from(read, done + 1)
    }
    known.set(place, matched)
    return matched
  }
  return from(0, 0)
}

/** What a fitting name looks like: "what_detail_01.wav". */
export function exampleOf({ tokens, separator, extension }: Naming): string {
  const parts = tokens.map((token) => {
    if (token.one_of) return token.one_of[0] ?? token.name
    if (token.digits !== undefined) return '1'.padStart(token.digits, '0')
    const plain = token.name.replaceAll(/[^a-z0-9]/g, '')
    if (token.case === 'upper') return plain.toUpperCase()
    return token.case === 'capital' ? plain.charAt(0).toUpperCase() + plain.slice(1) : plain
  })
  return parts.length === 0 ? '' : parts.join(separator) + extension
}

/** A name put into the convention, where only separators or letters differ; null where that is not enough. */
export function correctedName(naming: Naming, fileName: string): string | null {
  const { extension, separator, tokens } = naming
  const stem = fileName.replace(/\.[A-Za-z0-9]{2,4}$/, '')
  const joined = stem.split(/[\s_.-]+/).join(separator)
  const letters = tokens.find((token) => token.case)?.case
  const cased = letters === 'upper' ? joined.toUpperCase() : letters === 'lower' ? joined.toLowerCase() : joined
  const corrected = cased + extension
  return readName(naming, corrected) ? corrected : null
}

const SEPARATORS = ['_', '-', '.']

/** The convention that names already follow, read from a paste; null where they have none in common. */
export function namingFrom(text: string): Naming | null {
  const names = text.split(/\s+/).filter(Boolean).slice(0, 2000)
  const stems = names.map((name) => (name.split(/[\\/]/).at(-1) ?? '').replace(/\.(wav|flac|ogg|mp3|aiff?)$/i, ''))
  if (stems.length === 0) return null
  const counts = SEPARATORS.map((separator) => stems.filter((stem) => stem.includes(separator)).length)
  const separator = SEPARATORS[counts.indexOf(Math.max(...counts))] ?? '_'
  const parts = stems.map((stem) => stem.split(separator))
  const last = parts.map((all) => (all.length > 1 ? (all.at(-1) ?? '') : ''))
  const numbers = last.filter((part) => /^\d{1,6}$/.test(part))
  const digits =
    numbers.length > 0 && numbers.every((number) => number.length === numbers[0]?.length) ? numbers[0]?.length : 0
  const words = parts.flatMap((all) => (digits && /^\d+$/.test(all.at(-1) ?? '') ? all.slice(0, -1) : all))
  const letters = (Object.keys(LETTERS) as (keyof typeof LETTERS)[]).find((kind) =>
    words.every((word) => new RegExp(`^${LETTERS[kind]}$`).test(word)),
  )
  if (letters === undefined) return null
  const longest = Math.max(...parts.map((all) => all.length - (digits && /^\d+$/.test(all.at(-1) ?? '') ? 1 : 0)))
  const naming: Naming = {
    tokens: [
      { name: 'what', case: letters },
      ...(longest > 1 ? [{ name: 'detail', case: letters, repeats: true, optional: true }] : []),
      ...(digits ? [{ name: 'variation', digits, optional: true }] : []),
    ],
    separator,
    extension: '.wav',
  }
  return stems.every((stem) => readName(naming, stem) !== null) ? naming : null
}
