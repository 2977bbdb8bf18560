import { describe, expect, test } from 'vitest'

import { anItem, aTake } from '@/test/review'

import { withoutVerdict, withVerdictBack } from './afterVerdict'
import type { QueueItem, QueuePage } from './api'

const item = (id: string, ...takes: [id: string, variation: number][]) =>
  anItem(
    { id, name: id },
    takes.map(([take, variation]) => aTake(take, { variation })),
  )
const page = (...items: QueueItem[]): QueuePage => ({ items, next: null })
const shown = (pages: readonly QueuePage[]) =>
  pages.map(({ items }) => items.map(({ cue, takes }) => `${cue.id}: ${takes.map(({ id }) => id).join(' ')}`))
const decided = (cueId: string, ...takeIds: string[]) => ({ cueId, takeIds, picked: true })

const first = item('door', ['d1', 1])
const middle = item('walk', ['w1', 1], ['w1b', 1], ['w2', 2])
const last = item('laser', ['l1', 1])
const before = [page(first, middle), page(last)]
const after = (...what: ReturnType<typeof decided>[]) =>
  before.map(({ items }) => page(...what.reduce<QueueItem[]>(withoutVerdict, items)))

describe('the queue once a decision was undone', () => {
  test.each([decided('door', 'd1'), decided('walk', 'w1', 'w2'), decided('laser', 'l1')])(
    '%j is there again, at its place of before',
    (what) => {
      expect(withVerdictBack(after(what), before, what).flatMap(({ items }) => items)).toEqual([first, middle, last])
    },
  )

  test('the alternates of one variation are there again among the others of their cue', () => {
    const what = decided('walk', 'w1')
    expect(shown(after(what))).toEqual([['door: d1', 'walk: w2'], ['laser: l1']])
    expect(shown(withVerdictBack(after(what), before, what))).toEqual(shown(before))
  })

  test('what was decided since stays decided', () => {
    const what = decided('walk', 'w1')
    const since = after(what, decided('walk', 'w2'), decided('door', 'd1'))
    expect(shown(withVerdictBack(since, before, what))).toEqual([['walk: w1 w1b'], ['laser: l1']])
  })

  test('a queue that has another order by now is not changed but for it', () => {
    const what = decided('walk', 'w1', 'w2')
    expect(shown(withVerdictBack([page(last), page(first)], before, what))).toEqual([
      ['laser: l1'],
      ['door: d1', 'walk: w1 w1b w2'],
    ])
  })
})
