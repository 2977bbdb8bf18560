import { expect, test } from 'vitest'

import { ApiProblem } from '@/api'
import { aCue } from '@/test/soundList'

import { changedFacts, changesBetween, draftOf, EMPTY_DRAFT, readDraft, rebased, refusedRows } from './draft'
import { blankRow, isBlank, withPasted, ensureTrailingBlankRow } from '../list/newRows'

test('figures are read with a point or a comma, and an empty one is none', () => {
  const read = (duration_s: string) => readDraft({ ...EMPTY_DRAFT, name: 'a', duration_s })
  expect(read('0,8').facts.duration_s).toBe(0.8)
  expect(read(' 1.5 s').facts.duration_s).toBe(1.5)
  expect(read('').facts.duration_s).toBeNull()
  expect(read('long').faults).toEqual({ duration_s: 'Enter seconds such as 1.5 (found “long”).' })
  expect(readDraft({ ...EMPTY_DRAFT, name: 'a', variations: '2.5' }).faults.variations).toMatch(/whole number/)
  expect(readDraft(EMPTY_DRAFT).faults).toEqual({ name: 'Enter a name.' })
})

test('only what was typed is sent, and it stays on top of what another person changed', () => {
  const base = aCue(1, 'a', { use: 'Door', duration_s: 1 })
  const draft = { ...draftOf(base), duration_s: '1,2' }
  expect(changedFacts(base, draft)).toEqual({ duration_s: 1.2 })
  const fresh = { ...base, use: 'Hatch', duration_s: 3, edition: 2 }
  expect(changesBetween(base, fresh)).toEqual([
    { field: 'use', before: 'Door', after: 'Hatch' },
    { field: 'duration_s', before: 1, after: 3 },
  ])
  const mine = rebased(base, fresh, draft)
  expect([mine.use, mine.duration_s]).toEqual(['Hatch', '1,2'])
  expect(changedFacts(fresh, mine)).toEqual({ duration_s: 1.2 })
})

test('refusals find their row and their field, however the server names them', () => {
  const rows = refusedRows(
    new ApiProblem(422, {
      code: 'rows-invalid',
      detail: '',
      errors: [
        { field: 'row 2: name', message: 'is taken' },
        { field: 'body.cues.0.duration_s', message: 'Input should be a number' },
        { field: 'row 2: extra', message: 'too many' },
      ],
    }),
  )
  expect(rows.get(1)).toEqual({ fields: { name: 'Is taken.' }, whole: ['Too many.'] })
  expect(rows.get(0)?.fields).toEqual({ duration_s: 'Input should be a number.' })
})

test('a pasted block fills rows from its cell on, and one blank row is always left', () => {
  const rows = withPasted(ensureTrailingBlankRow([]), 0, 'category', 'foley\tDoor\r\nui\tMenu\r\n')
  expect(rows.map(({ draft }) => [draft.category, draft.use])).toEqual([
    ['foley', 'Door'],
    ['ui', 'Menu'],
    ['', ''],
  ])
  expect(rows.filter(isBlank)).toHaveLength(1)
  const flags = withPasted([blankRow('a')], 0, 'variations', '4\tyes\tlocked')[0]?.draft
  expect([flags?.name, flags?.variations, flags?.loop, flags?.state]).toEqual(['a', '4', true, 'locked'])
})
