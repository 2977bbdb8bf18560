import { expect, test } from 'vitest'

import type { WriteKind } from '@/api'

import { keptWords } from './kept'

const KEPT: [kept: WriteKind[], words: string][] = [
  [[], ''],
  [['undo'], '1 undo'],
  [['comment', 'verdict', 'verdict'], '2 verdicts and 1 comment'],
  [['comment', 'undo', 'verdict', 'undo'], '1 verdict, 2 undos and 1 comment'],
]

test.each(KEPT)('what is kept, %j, reads “%s”', (kept, words) => {
  expect(keptWords(kept)).toBe(words)
})
