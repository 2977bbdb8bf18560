import { expect, test } from 'vitest'

import { clock, frameRateOf, nameOf, neighbour, NO_MARKS, withChange, withMark, withoutMark } from './marks'

test('marks stand in the order of the clip, to the millisecond', () => {
  const spotted = withMark(withMark(NO_MARKS, 4.00049), 1.23456)
  expect(spotted.marks.map(({ id, startS }) => [id, startS])).toEqual([
    [2, 1.235],
    [1, 4],
  ])
  const moved = withChange(spotted, 2, { startS: 9 })
  expect(moved.marks.map(({ id }) => id)).toEqual([1, 2])
  expect(withChange(spotted, 2, { startS: -3 }).marks[0]?.startS).toBe(0)
})

test('a length below a millisecond is none', () => {
  const spotted = withMark(NO_MARKS, 1)
  expect(withChange(spotted, 1, { lengthS: 0.0004 }).marks[0]?.lengthS).toBeNull()
  expect(withChange(spotted, 1, { lengthS: 0.50049 }).marks[0]?.lengthS).toBe(0.5)
})

test('an id is never used again', () => {
  expect(withMark(withoutMark(withMark(NO_MARKS, 1), 1), 1).marks[0]?.id).toBe(2)
})

test('the next mark stops at either end', () => {
  const { marks } = withMark(withMark(NO_MARKS, 1), 2)
  expect(neighbour(marks, null, 1)?.id).toBe(1)
  expect(neighbour(marks, null, -1)?.id).toBe(2)
  expect(neighbour(marks, 2, 1)?.id).toBe(2)
  expect(neighbour(marks, 2, -1)?.id).toBe(1)
  expect(neighbour([], null, 1)).toBeUndefined()
})

test('a mark without a name is called after the clip', () => {
  const [mark] = withMark(NO_MARKS, 1).marks
  expect(mark && nameOf(mark, 1, 'walkway.final.mp4')).toBe('walkway.final 2')
  expect(mark && nameOf({ ...mark, name: ' Door ' }, 1, 'walkway.mp4')).toBe('Door')
})

test('the frame rate is read from the times of frames, also where one was left out', () => {
  expect(frameRateOf([0, 0.04, 0.12, 0.16])).toBe(25)
  expect(frameRateOf([0, 1 / 59.94, 2 / 59.94])).toBe(59.94)
  expect(frameRateOf([0, 0.125])).toBeNull()
  expect(frameRateOf([3])).toBeNull()
})

test('an instant reads minutes, seconds and milliseconds', () => {
  expect(clock(101.2044)).toBe('1:41.204')
  expect(clock(59.9996)).toBe('1:00.000')
})
