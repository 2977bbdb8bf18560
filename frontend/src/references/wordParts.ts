import type { Reference } from './api'

interface Part {
  text: string
  /** What lets one hear the word; missing for plain text. */
  reference?: Reference
}

const escaped = (word: string) => word.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&')

const wordsOf = ({ words }: Reference): string[] => words.split(', ').filter(Boolean)

interface Words {
  byWord: ReadonlyMap<string, Reference>
  /** null for a list without words. */
  pattern: RegExp | null
}

const byList = new WeakMap<readonly Reference[], Words>() // a text is split again on every key that is typed

/** The words of a list and what finds them: whole words, in any case, the longest first. */
function wordsIn(list: readonly Reference[]): Words {
  const cached = byList.get(list)
  if (cached) return cached
  const byWord = new Map<string, Reference>()
  for (const reference of list) {
    for (const word of wordsOf(reference)) if (!byWord.has(word)) byWord.set(word, reference)
  }
  const longest = [...byWord.keys()].toSorted((a, b) => b.length - a.length)
  const pattern =
    longest.length > 0
      ? new RegExp(`(?<![\\p{L}\\p{N}])(${longest.map(escaped).join('|')})(?![\\p{L}\\p{N}])`, 'giu')
      : null
  const words = { byWord, pattern }
  byList.set(list, words)
  return words
}

/** A text in its order, the words of the list apart. */
export function partsOf(text: string, list: readonly Reference[]): Part[] {
  const { byWord, pattern } = wordsIn(list)
  if (pattern === null) return [{ text }]
  return text
    .split(pattern)
    .map((piece, at) => (at % 2 === 1 ? { text: piece, reference: byWord.get(piece.toLowerCase()) } : { text: piece }))
    .filter(({ text: piece }) => piece !== '')
}
