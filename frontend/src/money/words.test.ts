import { describe, expect, test } from 'vitest'

import { amount, minorOf, money, percent, slipInWords } from './words'

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
