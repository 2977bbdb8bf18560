/** Figures as people of sound read them: a true minus, a space before the unit, never a guess at digits. */

const MINUS = '−'

/** One for each count of decimals: making one takes longer than using it a hundred times, and lists have thousands of figures. */
const FORMATS = new Map<number, Intl.NumberFormat>()

function formatOf(decimals: number): Intl.NumberFormat {
  const cached = FORMATS.get(decimals)
  if (cached) return cached
  const format = new Intl.NumberFormat('en-GB', { minimumFractionDigits: decimals, maximumFractionDigits: decimals })
  FORMATS.set(decimals, format)
  return format
}

/** A number with a true minus and a fixed count of decimals; never "−0.0". */
export function figure(value: number, decimals = 0): string {
  const text = formatOf(decimals).format(Math.abs(value))
  return value < 0 && /[1-9]/.test(text) ? MINUS + text : text
}

/** A score from 0 to 1 in two decimals, cut off as the findings cut it: 0.995 reads 0.99, and 1.00 is only what is 1. */
export function score(value: number): string {
  return figure(Math.floor(Math.round(value * 1000) / 10) / 100, 2)
}

/** A share from 0 to 1: "75 %"; "under 1 %" and "over 99 %" keep 0 % and 100 % for none and all. */
export function share(value: number): string {
  const percent = Math.round(value * 100)
  if (value > 0 && percent === 0) return 'under 1 %'
  if (value < 1 && percent === 100) return 'over 99 %'
  return `${figure(percent)} %`
}

/** A mean of counts with one decimal: "1.5"; "under 0.1" keeps 0.0 for none. */
export function average(value: number): string {
  return value > 0 && value < 0.05 ? 'under 0.1' : figure(value, 1)
}

/** By how much something differs, signed: "+30 %", "−12 %", "+0.4 %"; "0 %" is only what is equal to a tenth. */
export function deviation(percent: number): string {
  const text = figure(percent, Math.abs(percent) < 0.95 ? 1 : 0)
  if (text === '0.0') return '0 %'
  return `${percent > 0 ? '+' : ''}${text} %`
}

export type LevelUnit = 'dB' | 'dBFS' | 'dBTP' | 'LUFS' | 'LU'

/** A level with one decimal; null, NaN and −Infinity are silence: "−∞ dBFS". */
export function level(value: number | null | undefined, unit: LevelUnit = 'dB'): string {
  const silent = value === null || value === undefined || Number.isNaN(value) || value === -Infinity
  return `${silent ? `${MINUS}∞` : figure(value, 1)} ${unit}`
}

/** A gain, signed either way: "+1.4 dB", "−2.1 dB", and "as sent" for none. */
export function gain(db: number): string {
  const text = figure(db, 1)
  if (text === '0.0') return 'as delivered'
  return `${db > 0 ? '+' : ''}${text} dB`
}

/** A place inside a sound, to the millisecond: "0.418 s". */
export function place(s: number): string {
  return `${figure(s, 3)} s`
}

/** A range inside a sound: "0.307–0.462 s". */
export function range(startS: number, endS: number): string {
  return `${figure(startS, 3)}–${figure(endS, 3)} s`
}

/** How long a sound is: "0.84 s". */
export function length(s: number): string {
  return `${figure(s, 2)} s`
}

interface LengthAsked {
  duration_s: number | null
  duration_min_s: number | null
  duration_max_s: number | null
}

/** How long a cue is to be: "0.80 s", "0.5–1 s", "at most 2 s"; empty where nothing is asked. */
export function lengthAsked({ duration_s, duration_min_s: least, duration_max_s: most }: LengthAsked): string {
  if (least !== null && most !== null) return `${exact(least)}–${exact(most)} s`
  if (least !== null) return `at least ${exact(least)} s`
  if (most !== null) return `at most ${exact(most)} s`
  return duration_s === null ? '' : length(duration_s)
}

const exact = (s: number): string => String(Number(s.toFixed(6)))

/** A place in words, for those who listen to the page: "0.286 seconds". */
export function placeInWords(s: number): string {
  return `${figure(s, 3)} seconds`
}

/** "412 ms" below a second, "1.2 s" above. */
export function milliseconds(ms: number): string {
  return Math.abs(ms) < 1000 ? `${figure(ms)} ms` : `${figure(ms / 1000, 1)} s`
}

/** "48 kHz", "44.1 kHz", "22.05 kHz". */
export function rate(hz: number): string {
  return `${(hz / 1000).toLocaleString('en-GB', { maximumFractionDigits: 3 })} kHz`
}

/** "mono", "stereo", "6 channels". */
export function channels(count: number): string {
  return count === 1 ? 'mono' : count === 2 ? 'stereo' : `${count} channels`
}

/** What codecs are called. */
const CODECS: Record<string, string> = { vorbis: 'Ogg Vorbis', opus: 'Opus', flac: 'FLAC', mp3: 'MP3' }

/** How samples are kept: "16 bit", "32 bit float", "16-bit FLAC", "Ogg Vorbis, quality 0.5". */
export function sampleFormat(bits: number | undefined, encoding: unknown, quality?: number | null): string {
  const codec = typeof encoding === 'string' ? CODECS[encoding] : undefined
  if (codec && encoding !== 'flac') {
    return typeof quality === 'number' ? `${codec}, quality ${quality}` : codec
  }
  const depth = bits ? `${bits} bit` : ''
  if (codec) return bits ? `${bits}-bit ${codec}` : codec
  return depth && encoding === 'float' ? `${depth} float` : depth
}

/** "17.3 MB", in thousands as disks are sold; whole bytes below one thousand. */
export function bytes(count: number): string {
  const units = ['kB', 'MB', 'GB', 'TB']
  if (count < 1000) return plural(count, 'byte')
  let value = count / 1000
  let unit = 0
  while (value >= 999.95 && unit < units.length - 1) {
    value /= 1000
    unit += 1
  }
  return `${figure(value, 1)} ${units[unit]}`
}

/** "9.1 of 17.3 MB": both in the unit of the whole. */
export function bytesOf(done: number, whole: number): string {
  const [, unit = 'bytes'] = bytes(whole).split(' ')
  const size = { bytes: 1, kB: 1e3, MB: 1e6, GB: 1e9, TB: 1e12 }[unit] ?? 1
  const decimals = unit === 'bytes' ? 0 : 1
  return `${figure(done / size, decimals)} of ${figure(whole / size, decimals)} ${unit}`
}

/** "4 of 4". */
export function countOf(part: number, whole: number): string {
  return `${figure(part)} of ${figure(whole)}`
}

/** "1 cue", "3 cues". */
export function plural(count: number, one: string, many = `${one}s`): string {
  return `${figure(count)} ${count === 1 ? one : many}`
}

const MINUTE = 60_000
const HOUR = 60 * MINUTE
const DAY = 24 * HOUR

/** How long something waits: "now", "20 min", "2 h", "5 days". */
export function age(from: Date | string, now: Date = new Date()): string {
  const ms = now.getTime() - new Date(from).getTime()
  if (ms < MINUTE) return 'now'
  if (ms < HOUR) return `${Math.floor(ms / MINUTE)} min`
  if (ms < DAY) return `${Math.floor(ms / HOUR)} h`
  return plural(Math.floor(ms / DAY), 'day')
}

/** How long ago, in words: "just now", "20 min ago". */
export function ago(at: Date | string, now: Date = new Date()): string {
  const passed = age(at, now)
  return passed === 'now' ? 'just now' : `${passed} ago`
}

/** How long something took: "under 1 s", "8 s", "12 min", "3 hours", "2 days"; the unit never says more than is known. */
export function duration(s: number): string {
  if (s <= 0) return '0 s'
  if (s < 0.5) return 'under 1 s'
  if (Math.round(s) < 60) return `${Math.round(s)} s`
  if (Math.round(s / 60) < 60) return `${Math.round(s / 60)} min`
  if (Math.round(s / 3600) < 48) return plural(Math.round(s / 3600), 'hour')
  return plural(Math.round(s / 86_400), 'day')
}

/** Days that may be a half, as a median is: "1 day", "0.5 days", "12 days". */
export function days(count: number): string {
  return Number.isInteger(count) ? plural(count, 'day') : `${figure(count, 1)} days`
}

/** How long something still takes: "40 s", "3 min", "2 h". */
export function remaining(s: number): string {
  if (s < 60) return `${Math.max(1, Math.ceil(s))} s`
  if (s < 3600) return `${Math.ceil(s / 60)} min`
  return `${Math.ceil(s / 3600)} h`
}

const WEEKDAYS = ['Sunday', 'Monday', 'Tuesday', 'Wednesday', 'Thursday', 'Friday', 'Saturday']
const MONTHS = [
  'January',
  'February',
  'March',
  'April',
  'May',
  'June',
  'July',
  'August',
  'September',
  'October',
  'November',
  'December',
]

/** A day without an hour ("2026-11-20") is that day everywhere, not midnight in London. */
function dayOf(on: Date | string): Date {
  const parts = typeof on === 'string' ? /^(\d{4})-(\d{2})-(\d{2})$/.exec(on) : null
  if (parts) return new Date(Number(parts[1]), Number(parts[2]) - 1, Number(parts[3]))
  const date = new Date(on)
  return new Date(date.getFullYear(), date.getMonth(), date.getDate())
}

const daysBetween = (from: Date, to: Date): number => Math.round((dayOf(to).getTime() - dayOf(from).getTime()) / DAY)

/** "Friday 20 November", with the year where it is not this one. */
export function day(on: Date | string, now: Date = new Date()): string {
  return `${WEEKDAYS[dayOf(on).getDay()]} ${shortDay(on, now)}`
}

/** "20 November", with the year where it is not this one: "20 January 2029". */
export function shortDay(on: Date | string, now: Date = new Date()): string {
  const date = dayOf(on)
  const year = date.getFullYear() === now.getFullYear() ? '' : ` ${date.getFullYear()}`
  return `${date.getDate()} ${MONTHS[date.getMonth()]}${year}`
}

/** How far a day is, within a week: "today", "tomorrow", "in 3 days", "yesterday", "3 days ago"; else nothing. */
function nearness(on: Date | string, now: Date = new Date()): string | null {
  const days = daysBetween(now, dayOf(on))
  if (days === 0) return 'today'
  if (days === 1) return 'tomorrow'
  if (days === -1) return 'yesterday'
  if (Math.abs(days) > 7) return null
  return days > 0 ? `in ${days} days` : `${-days} days ago`
}

/** "Friday 20 November, in 3 days": the day, and within a week how far it is. */
export function dueDay(on: Date | string, now: Date = new Date()): string {
  return [day(on, now), nearness(on, now)].filter(Boolean).join(', ')
}

/** The current day here, as date fields take it: "2026-11-20". */
export function today(now: Date = new Date()): string {
  return new Date(now.getTime() - now.getTimezoneOffset() * MINUTE).toISOString().slice(0, 10)
}

/** "14:05", on the 24-hour clock. */
export function clock(at: Date | string): string {
  const date = new Date(at)
  return `${String(date.getHours()).padStart(2, '0')}:${String(date.getMinutes()).padStart(2, '0')}`
}
