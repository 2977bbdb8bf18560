import { describe, expect, test, vi } from 'vitest'

import * as format from './format'

const NOW = new Date(2026, 10, 17, 12, 0, 0)
const before = (ms: number) => new Date(NOW.getTime() - ms)
const MINUTE = 60_000
const HOUR = 60 * MINUTE
const DAY = 24 * HOUR

describe('levels', () => {
  test.each([
    [-0.6, 'dBTP', '−0.6 dBTP'],
    [0, 'dBFS', '0.0 dBFS'],
    [-0.04, 'dBFS', '0.0 dBFS'],
    [-0.05, 'dBFS', '−0.1 dBFS'],
    [-14.24, 'LUFS', '−14.2 LUFS'],
    [null, 'dBFS', '−∞ dBFS'],
    [-Infinity, 'LUFS', '−∞ LUFS'],
  ] as const)('%s %s is written %s', (value, unit, text) => {
    expect(format.level(value, unit)).toBe(text)
  })

  test.each([
    [1.4, '+1.4 dB'],
    [-2.1, '−2.1 dB'],
    [0.04, 'as delivered'],
  ])('a gain of %s is written %s', (db, text) => {
    expect(format.gain(db)).toBe(text)
  })
})

test('places have three decimals, lengths two', () => {
  expect(format.place(0.418)).toBe('0.418 s')
  expect(format.range(0.307, 0.462)).toBe('0.307–0.462 s')
  expect(format.length(0.8399)).toBe('0.84 s')
  expect(format.milliseconds(412)).toBe('412 ms')
  expect(format.milliseconds(1500)).toBe('1.5 s')
})

test.each([
  [48_000, '48 kHz'],
  [44_100, '44.1 kHz'],
  [22_050, '22.05 kHz'],
  [11_025, '11.025 kHz'],
])('%s Hz is written %s', (hz, text) => {
  expect(format.rate(hz)).toBe(text)
})

test.each([
  [0, '0 bytes'],
  [1, '1 byte'],
  [2, '2 bytes'],
  [999, '999 bytes'],
  [1000, '1.0 kB'],
  [999_949, '999.9 kB'],
  [999_960, '1.0 MB'],
  [17_300_000, '17.3 MB'],
  [2_147_483_648, '2.1 GB'],
])('%s bytes are written %s', (count, text) => {
  expect(format.bytes(count)).toBe(text)
})

test('a part is counted in the unit of its whole', () => {
  expect(format.bytesOf(9_100_000, 17_300_000)).toBe('9.1 of 17.3 MB')
  expect(format.bytesOf(0, 17_300_000)).toBe('0.0 of 17.3 MB')
  expect(format.bytesOf(12, 900)).toBe('12 of 900 bytes')
})

test.each([
  [0, 'now'],
  [MINUTE - 1, 'now'],
  [20 * MINUTE, '20 min'],
  [2 * HOUR, '2 h'],
  [DAY - 1, '23 h'],
  [DAY, '1 day'],
  [5 * DAY, '5 days'],
])('what waits %s ms is %s old', (ms, text) => {
  expect(format.age(before(ms), NOW)).toBe(text)
})

test.each([
  ['2026-11-20', 'Friday 20 November, in 3 days'],
  ['2026-11-17', 'Tuesday 17 November, today'],
  ['2026-11-18', 'Wednesday 18 November, tomorrow'],
  ['2026-11-16', 'Monday 16 November, yesterday'],
  ['2026-11-24', 'Tuesday 24 November, in 7 days'],
  ['2026-12-18', 'Friday 18 December'],
  ['2027-01-02', 'Saturday 2 January 2027'],
])('%s is due %s', (on, text) => {
  expect(format.dueDay(on, NOW)).toBe(text)
})

test('how samples are kept: by their depth, or by codec and quality', () => {
  expect(format.sampleFormat(16, 'pcm')).toBe('16 bit')
  expect(format.sampleFormat(32, 'float')).toBe('32 bit float')
  expect(format.sampleFormat(24, 'flac')).toBe('24-bit FLAC')
  expect(format.sampleFormat(32, 'vorbis', 0.4)).toBe('Ogg Vorbis, quality 0.4')
  expect(format.sampleFormat(32, 'opus')).toBe('Opus')
  expect(format.sampleFormat(undefined, undefined)).toBe('')
})

test('counts and words', () => {
  expect(format.countOf(4, 4)).toBe('4 of 4')
  expect(format.plural(1, 'cue')).toBe('1 cue')
  expect(format.plural(3, 'cue')).toBe('3 cues')
  expect(format.plural(1024, 'file')).toBe('1,024 files')
  expect(format.remaining(40)).toBe('40 s')
  expect(format.remaining(61)).toBe('2 min')
  expect(format.channels(1)).toBe('mono')
  expect(format.channels(6)).toBe('6 channels')
})

test.each([
  [0, '0 %'],
  [0.004, 'under 1 %'],
  [0.125, '13 %'],
  [0.996, 'over 99 %'],
  [1, '100 %'],
])('a share of %s reads %s: none and all are only what they say', (value, text) => {
  expect(format.share(value)).toBe(text)
})

test.each([
  [0, '0.0'],
  [0.03, 'under 0.1'],
  [0.05, '0.1'],
  [0.75, '0.8'],
  [3, '3.0'],
])('a mean of %s reads %s', (value, text) => {
  expect(format.average(value)).toBe(text)
})

test.each([
  [0, '0 %'],
  [0.4, '+0.4 %'],
  [-0.4, '−0.4 %'],
  [0.96, '+1 %'],
  [30.4, '+30 %'],
  [-12, '−12 %'],
])('a deviation of %s reads %s', (value, text) => {
  expect(format.deviation(value)).toBe(text)
})

test.each([
  [0, '0 s'],
  [0.2, 'under 1 s'],
  [8, '8 s'],
  [59.6, '1 min'],
  [90, '2 min'],
  [59 * 60, '59 min'],
  [3600, '1 hour'],
  [5 * 3600, '5 hours'],
  [47 * 3600, '47 hours'],
  [48 * 3600, '2 days'],
  [70 * 3600, '3 days'],
])('a duration of %s s reads %s', (seconds, text) => {
  expect(format.duration(seconds)).toBe(text)
})

test('days may be half', () => {
  expect([0, 0.5, 1, 2, 2.5].map(format.days)).toEqual(['0 days', '0.5 days', '1 day', '2 days', '2.5 days'])
})

test('today is the day of this place, not that of Greenwich', () => {
  const now = new Date('2026-11-19T23:30:00Z')
  vi.spyOn(now, 'getTimezoneOffset').mockReturnValue(-60)
  expect(format.today(now)).toBe('2026-11-20')
})

test('a short day names its year where it is not the current one', () => {
  const now = new Date(2026, 10, 28)
  expect(format.shortDay('2026-01-20', now)).toBe('20 January')
  expect(format.shortDay('2029-01-20', now)).toBe('20 January 2029')
  expect(format.shortDay('2025-12-31', now)).toBe('31 December 2025')
})

test.each([
  [0, '0.00'],
  [0.29, '0.29'], // 0.29 * 100 is 28.999999999999996
  [0.995, '0.99'],
  [0.999, '0.99'],
  [1, '1.00'],
])('a score of %s reads %s', (value, text) => {
  expect(format.score(value)).toBe(text)
})
