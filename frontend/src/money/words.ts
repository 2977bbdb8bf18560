import { figure, plural, shortDay } from '@/ui/format'

import type { CueMoney, Effort } from './api'

/** Sums as people read them: "$7,200.00", a true minus, as many decimals as the currency has. */

function formatOf(currency: string, style: 'currency' | 'decimal'): { text: Intl.NumberFormat; digits: number } {
  const digits =
    new Intl.NumberFormat('en-US', { style: 'currency', currency }).resolvedOptions().maximumFractionDigits ?? 2
  const decimals = { minimumFractionDigits: digits, maximumFractionDigits: digits }
  return { text: new Intl.NumberFormat('en-US', { style, currency, ...decimals }), digits }
}

function written(amountMinor: number, currency: string, style: 'currency' | 'decimal'): string {
  const { text, digits } = formatOf(currency, style)
  return text.format(amountMinor / 10 ** digits).replace('-', '−')
}

/** "$697.50". */
export const money = (amountMinor: number, currency: string): string => written(amountMinor, currency, 'currency')

/** "697.50", where the currency is shown next to it. */
export const amount = (amountMinor: number, currency: string): string => written(amountMinor, currency, 'decimal')

/** A typed amount in whole minor units; null if it is none. */
export function minorOf(typed: string, currency: string): number | null {
  const { digits } = formatOf(currency, 'decimal')
  const match = /^([−-]?)(\d{1,10})(?:\.(\d+))?$/.exec(typed.replaceAll(/[,\s]/g, ''))
  if (!match || (match[3] ?? '').length > digits) return null
  const minor = Number(match[2]) * 10 ** digits + Number((match[3] ?? '').padEnd(digits, '0') || '0')
  return match[1] ? -minor : minor
}

/** "3 h", "2 h 30 min", "45 min". */
export function hours(minutes: number): string {
  const whole = Math.floor(minutes / 60)
  const rest = minutes % 60
  return [whole > 0 || rest === 0 ? `${whole} h` : '', rest > 0 ? `${rest} min` : ''].filter(Boolean).join(' ')
}

/** Typed hours in minutes: "1.5", "1:30", "1 h 30 min"; null if it is none, or more than a day has. */
export function minutesOf(typed: string): number | null {
  const text = typed.trim().toLowerCase().replace(',', '.')
  const parted = /^(?:(\d{1,2})(?::| ?h ?))?(?:(\d{1,4})(?: ?min)?)?$/.exec(text)
  const whole = /^(\d{0,2}\.?\d*) ?h?$/.exec(text)
  let minutes = 0
  if (/[:h]|min/.test(text) && parted) minutes = Number(parted[1] ?? 0) * 60 + Number(parted[2] ?? 0)
  else if (whole && text !== '') minutes = Math.round(Number(whole[1]) * 60)
  return minutes >= 1 && minutes <= 24 * 60 ? minutes : null
}

/** "50 %", "12.5 %". */
export const percent = (basisPoints: number): string => `${Number((basisPoints / 100).toFixed(2))} %`

/** "$180.00 is due then, and Alpha is 4 of 10."; empty where accepting the cue changes nothing. */
export function dueWithPick({
  accepted,
  accepted_then,
  wanted,
  milestone,
  would_owe_minor,
  currency,
}: CueMoney): string {
  if (accepted_then === accepted && would_owe_minor === 0) return ''
  const stands = `${milestone} is ${accepted_then} of ${wanted}`
  return would_owe_minor > 0 ? `${money(would_owe_minor, currency)} is due then, and ${stands}.` : `${stands} then.`
}

/** "4 days late: 1 with the designer, 3 with you." */
export function slipInWords(
  { days, designer_days: designer, studio_days: studio }: { days: number; designer_days: number; studio_days: number },
  side: 'team' | 'designer',
): string {
  if (days === 0) return 'on time'
  const late = `${plural(days, 'day')} late`
  const [you, they] = side === 'team' ? [studio, designer] : [designer, studio]
  const whose = side === 'team' ? 'the designer' : 'the studio'
  const parts = [they > 0 ? `${they} with ${whose}` : '', you > 0 ? `${you} with you` : ''].filter(Boolean)
  return `${late}: ${parts.join(', ')}`
}

/** "3 of 12 cues are concepts, for EUR 480.00 …": what is ordered so may change or go. */
export const conceptWords = (
  { count, cues, amount_minor: minor }: { count: number; cues: number; amount_minor: number },
  currency: string,
): string =>
  `${count} of ${plural(cues, 'cue')} ${count === 1 ? 'is a concept' : 'are concepts'} still, for ${money(minor, currency)}: settle ${count === 1 ? 'it' : 'them'} before you order, or the work may be thrown away.`

/** "140–190 h", "1.2–2.8 h": hours from and to, whole from five on. */
export function hoursRange({ low_h: low, high_h: high }: { low_h: number; high_h: number }): string {
  const whole = (hour: number) => figure(hour, hour < 5 && Math.round(hour * 10) % 10 !== 0 ? 1 : 0)
  return whole(low) === whole(high) ? `${whole(high)} h` : `${whole(low)}–${whole(high)} h`
}

const BASIS_WORDS: Record<Effort['lines'][number]['basis'], string> = {
  plan: 'the estimates of the plan',
  designer: 'the hours that this designer logged with you',
  studio: 'the hours that were logged with you',
  usual: 'usual figures',
}

/** "the hours that were logged with you (12 cues)". */
export const basisWords = ({ basis, based_on: count }: Effort['lines'][number]): string =>
  `${BASIS_WORDS[basis]}${count > 0 ? ` (${plural(count, 'cue')})` : ''}`

/** "60 cues, 143 files: about 140–190 h, by usual figures." */
export function effortWords(effort: Effort): string {
  const bases = [...new Set(effort.lines.map(({ basis }) => BASIS_WORDS[basis]))]
  return `${plural(effort.cues, 'cue')}, ${plural(effort.files, 'file')}: about ${hoursRange(effort)}, by ${bases.join(' and ')}.`
}

/** "At 30 h a week from 2 March, done between 12 March and 2 April." */
export function effortDays({ weekly_hours, begin_on, earliest_on, latest_on }: Effort): string {
  const pace = `At ${figure(weekly_hours)} h a week from ${shortDay(begin_on)}`
  if (earliest_on === null) return `${pace}, not done within five years.`
  if (latest_on === null) return `${pace}, done on ${shortDay(earliest_on)} at the earliest.`
  if (earliest_on === latest_on) return `${pace}, done by ${shortDay(latest_on)}.`
  return `${pace}, done between ${shortDay(earliest_on)} and ${shortDay(latest_on)}.`
}
