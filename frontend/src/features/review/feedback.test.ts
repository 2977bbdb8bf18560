import { expect, test } from 'vitest'

import { aCue, aDraft, anItem, aReview, aTake, APPROVER } from '@/test/review'

import { shuffled } from './blind'
import { marksOf, toFeedback } from './feedback'

const take = aTake('a')
const comment = (id: string, at: string, startS: number | null, endS: number | null = null) => ({
  id,
  take_id: 'a',
  reply_to_id: null as string | null,
  change_request_id: null as string | null,
  text: id,
  start_s: startS,
  end_s: endS,
  author: APPROVER,
  decides: true,
  created_at: at,
  resolved_at: null,
  mentions: [],
  acknowledgements: [],
})

test('what was said is numbered in time, where it has a place in the sound', () => {
  const review = aReview(anItem({}, [take]), {
    comments: [comment('later', '2026-11-20T12:00:00Z', 0.3, 0.46), comment('whole', '2026-11-20T09:00:00Z', null)],
    change_requests: [{ ...aDraft(take, aCue(), 'draft'), start_s: 0.1 }],
  })
  const said = toFeedback(review, [take])
  expect(said.map(({ id, number }) => [id, number])).toEqual([
    ['whole', null],
    ['draft-a', 1],
    ['later', 2],
  ])
  expect(marksOf(said, 'a')).toEqual([
    { id: 'draft-a', number: 1, startS: 0.1, endS: undefined },
    { id: 'later', number: 2, startS: 0.3, endS: 0.46 },
  ])
  expect(marksOf(said, 'b')).toEqual([])
})

test('replies stand below the note that they answer, and are no notes themselves', () => {
  const note = comment('note', '2026-11-20T09:00:00Z', 0.2)
  const change = { ...aDraft(take, aCue(), 'sent'), id: 'change', sent_at: '2026-11-20T09:30:00Z' }
  const review = aReview(anItem({}, [take]), {
    comments: [
      note,
      { ...comment('to the note', '2026-11-20T10:00:00Z', null), reply_to_id: 'note' },
      { ...comment('to the change', '2026-11-20T11:00:00Z', null), change_request_id: 'change' },
    ],
    change_requests: [change],
  })
  const said = toFeedback(review, [take])
  expect(said.map(({ id, replies }) => [id, replies.map(({ text }) => text)]).sort()).toEqual([
    ['change', ['to the change']],
    ['note', ['to the note']],
  ])
})

test('what is said of another take is left out', () => {
  const review = aReview(anItem({}, [take]), { comments: [comment('on a', '2026-11-20T09:00:00Z', 0)] })
  expect(toFeedback(review, [aTake('b')])).toEqual([])
})

test('a shuffle keeps everything, and every order can come', () => {
  const orders = new Set<string>()
  for (const first of [0, 0.4, 0.9]) {
    for (const second of [0, 0.9]) {
      const draws = [first, second]
      orders.add(shuffled(['A', 'B', 'C'], () => draws.shift() ?? 0).join(''))
    }
  }
  expect([...orders].sort()).toEqual(['ABC', 'ACB', 'BAC', 'BCA', 'CAB', 'CBA'])
})
