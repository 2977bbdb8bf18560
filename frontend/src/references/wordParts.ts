import type { Reference } from './api'

interface Part {
  text: string
  /** What lets one hear the word; missing for plain text. */
  reference?: Reference
}

const escaped = (word: string) => word.replaceAll(/[.*+?^${}()|[\]\\]/g, '\\$&')

const wordsOf = ({ words }: Reference): string[] => words.split(', ').filter(Boolean)

/** A text in its order, the words of the list apart: whole words, in any case, the longest first. */
export function partsOf(text: string, list: readonly Reference[]): Part[] {
  const byWord = new Map<string, Reference>()
  for (const reference of list) {
    for (const word of wordsOf(reference)) if (!byWord.has(word)) byWord.set(word, reference)
  }
  if (byWord.size === 0) return [{ text }]
  const longest = [...byWord.keys()].toSorted((one, other) => other.length - one.length)
  const pattern = new RegExp(`(?<![\\p{L}\\p{N}])(${longest.map(escaped).join('|')})(?![\\p{L}\\p{N}])`, 'giu')
  const pieces = text.split(pattern)
  return pieces
    .map((piece, at) => (at % 2 === 1 ? { text: piece, reference: byWord.get(piece.toLowerCase()) } : { text: piece }))
    .filter(({ text: piece }) => piece !== '')
}
