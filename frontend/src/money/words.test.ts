import { describe, expect, test } from 'vitest'

import { amount, conceptWords, hours, minorOf, minutesOf, money, percent, slipInWords } from './words'

describe('sums', () => {
  test('have as many decimals as their currency', () => {
    expect(money(720_000, 'USD')).toBe('$7,200.00')
    expect(money(-15_750, 'EUR')).toBe('−€157.50')
    expect(money(1_500, 'JPY')).toBe('¥1,500')
    expect(amount(69_750, 'USD')).toBe('697.50')
    expect(amount(1_500, 'KWD')).toBe('1.500')
  })

  test('are read from what is typed', () => {
    expect(minorOf('7,200.5', 'USD')).toBe(720_050)
    expect(minorOf('−157.50', 'EUR')).toBe(-15_750)
    expect(minorOf('1500', 'JPY')).toBe(1_500)
    expect(minorOf('0.001', 'USD')).toBeNull()
    expect(minorOf('much', 'USD')).toBeNull()
  })
})

test('parts of a whole', () => {
  expect(percent(5_000)).toBe('50 %')
  expect(percent(1_250)).toBe('12.5 %')
})

test('late days say with whom they went', () => {
  const slip = { days: 4, designer_days: 1, studio_days: 3 }
  expect(slipInWords(slip, 'team')).toBe('4 days late: 1 with the designer, 3 with you')
  expect(slipInWords(slip, 'designer')).toBe('4 days late: 3 with the studio, 1 with you')
  expect(slipInWords({ days: 0, designer_days: 0, studio_days: 0 }, 'team')).toBe('on time')
})

describe('hours', () => {
  test.each([
    [60, '1 h'],
    [90, '1 h 30 min'],
    [45, '45 min'],
    [0, '0 h'],
  ])('%i minutes read %s', (minutes, text) => expect(hours(minutes)).toBe(text))

  test.each([
    ['1.5', 90],
    ['1,5', 90],
    ['2', 120],
    ['1:30', 90],
    ['1 h 30 min', 90],
    ['1h', 60],
    ['45 min', 45],
    ['24', 1_440],
    ['25', null],
    ['0', null],
    ['', null],
    ['h', null],
    ['much', null],
  ])('%s is typed for %s minutes', (typed, minutes) => expect(minutesOf(typed)).toBe(minutes))
})

test('days late and concepts are read with 1 and 2', () => {
  const late = (days: number) => slipInWords({ days, designer_days: days, studio_days: 0 }, 'team')
  expect([0, 1, 2].map(late)).toEqual([
    'on time',
    '1 day late: 1 with the designer',
    '2 days late: 2 with the designer',
  ])
  const concepts = (count: number) => conceptWords({ count, cues: count, amount_minor: 4_000 }, 'EUR').split(',')[0]
  expect([1, 2].map(concepts)).toEqual(['1 of 1 cue is a concept still', '2 of 2 cues are concepts still'])
})
