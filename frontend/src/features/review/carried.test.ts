import { expect, test } from 'vitest'

import { aNote, APPROVER } from '@/test/review'

import { carriedMarks, carriedTo, isAnswered } from './carried'

const answer = (is_done: boolean, number: number) => ({ is_done, number, given_by: APPROVER, created_at: '2026-11-20' })
const second = { variation: 1, number: 2 }

test('notes of earlier versions of the same variation are carried over until they are done', () => {
  const notes = [
    aNote('open', 'a'),
    aNote('still', 'b', { answer: answer(false, 2) }),
    aNote('done here', 'c', { answer: answer(true, 2) }),
    aNote('other variation', 'd', { variation: 2 }),
    aNote('own', 'e', { number: 2 }),
  ]
  const ids = (number: number) => carriedTo(notes, { variation: 1, number }, 1, 0).map(({ note }) => note.id)
  expect(ids(2)).toEqual(['open', 'still', 'done here'])
  expect(ids(3)).toEqual(['open', 'still', 'own'])
  expect(ids(1)).toEqual([])
})

test('their places lie within the new version, and are numbered after its own', () => {
  const notes = [
    aNote('whole', 'a'),
    aNote('inside', 'b', { start_s: 0.2, end_s: 0.4 }),
    aNote('past the end', 'c', { start_s: 0.9, end_s: 1.2 }),
  ]
  const carried = carriedTo(notes, second, 0.6, 3)
  expect(carried.map(({ number, startS, endS }) => [number, startS, endS])).toEqual([
    [null, null, null],
    [4, 0.2, 0.4],
    [5, 0.6, 0.6],
  ])
  expect(carriedMarks(carried)).toEqual([
    { id: 'inside', number: 4, startS: 0.2, endS: 0.4 },
    { id: 'past the end', number: 5, startS: 0.6, endS: undefined },
  ])
})

test('what was said of an earlier version is asked again of this one', () => {
  const [one] = carriedTo([aNote('open', 'a', { answer: answer(false, 2) })], { variation: 1, number: 3 }, 1, 0)
  expect(one && isAnswered(one, { number: 3 })).toBe(false)
  expect(one && isAnswered(one, { number: 2 })).toBe(true)
})
