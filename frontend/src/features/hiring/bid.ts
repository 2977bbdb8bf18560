import { amount, minorOf } from '@/money/words'

import type { AskedLine, BidContent, BidLine } from './api'

/** One line of the form, as it is typed. */
export interface TypedLine {
  key: string
  kind: BidLine['kind']
  unit: BidLine['unit']
  quantity: string
  price: string
  note: string
  /** Off: the line is not offered. */
  isOffered: boolean
}

export interface TypedBid {
  lines: TypedLine[]
  hours: string
  from: string
  to: string
  exclusivity: NonNullable<BidContent['exclusivity']>
  otherWork: string
  equipment: string
  note: string
}

/** "7.5" in hundredths; null where it is not a figure with at most two decimals. */
export function hundredthsOf(typed: string): number | null {
  const match = /^(\d{1,4})(?:\.(\d{1,2}))?$/.exec(typed.trim())
  return match ? Number(match[1]) * 100 + Number((match[2] ?? '').padEnd(2, '0')) : null
}

const shown = (hundredths: number): string => String(hundredths / 100)

/** The form of a bid: every asked line, offered or not, and the extras. */
export function typedBid(asked: readonly AskedLine[], bid: BidContent | null, currency: string): TypedBid {
  const typed = (line: BidLine): TypedLine => ({
    key: line.key,
    kind: line.kind,
    unit: line.unit,
    quantity: shown(line.quantity_hundredths),
    price: amount(line.price_minor, currency),
    note: line.note ?? '',
    isOffered: true,
  })
  const lines = bid?.lines ?? []
  const rows = asked.map((line): TypedLine => {
    const offered = lines.find(({ kind, key }) => kind === 'asked' && key === line.key)
    if (offered) return typed(offered)
    return {
      key: line.key,
      kind: 'asked',
      unit: 'per_cue',
      quantity: String(line.cues),
      price: '',
      note: '',
      isOffered: bid === null,
    }
  })
  return {
    lines: [...rows, ...lines.filter(({ kind }) => kind !== 'asked').map(typed)],
    hours: typeof bid?.hours_hundredths === 'number' ? shown(bid.hours_hundredths) : '',
    from: bid?.from_on ?? '',
    to: bid?.to_on ?? '',
    exclusivity: bid?.exclusivity ?? 'unknown',
    otherWork: bid?.other_work ?? '',
    equipment: bid?.equipment ?? '',
    note: bid?.note ?? '',
  }
}

/** What is typed as it is sent, or what cannot be read. */
export function contentOf(typed: TypedBid, currency: string): { content: BidContent } | { wrong: string } {
  const lines: BidLine[] = []
  for (const { key, kind, unit, quantity, price, note, isOffered } of typed.lines) {
    if (!isOffered) continue
    const count = unit === 'flat' ? 100 : hundredthsOf(quantity)
    const minor = minorOf(price, currency)
    const name = key || kind
    if (count === null) return { wrong: `Enter how many for ${name}, such as 3 or 7.5.` }
    if (minor === null || minor < 0) return { wrong: `Enter a price in ${currency} for ${name}, such as 270.00.` }
    lines.push({ key, kind, unit, quantity_hundredths: count, price_minor: minor, note })
  }
  const hours = typed.hours.trim() === '' ? null : hundredthsOf(typed.hours)
  if (typed.hours.trim() !== '' && hours === null) return { wrong: 'Enter the hours, such as 160.' }
  return {
    content: {
      lines,
      hours_hundredths: hours,
      from_on: typed.from || null,
      to_on: typed.to || null,
      exclusivity: typed.exclusivity,
      other_work: typed.otherWork,
      equipment: typed.equipment,
      note: typed.note,
    },
  }
}

/** What a line comes to as far as it can be read; it is rounded once, as the server does. */
function lineMinor({ isOffered, unit, quantity, price }: TypedLine, currency: string): number {
  if (!isOffered) return 0
  const count = unit === 'flat' ? 100 : (hundredthsOf(quantity) ?? 0)
  return Math.floor((count * (minorOf(price, currency) ?? 0) + 50) / 100)
}

/** The sum of the lines that can be read. */
export const totalOf = (typed: TypedBid, currency: string): number =>
  typed.lines.reduce((sum, line) => sum + lineMinor(line, currency), 0)

/** The part of it that is for cues that are concepts still. */
export const conceptsOf = (typed: TypedBid, asked: readonly AskedLine[], currency: string): number =>
  typed.lines.reduce((sum, line) => {
    const of = line.kind === 'asked' ? asked.find(({ key }) => key === line.key) : undefined
    return of && of.cues > 0 ? sum + Math.floor((lineMinor(line, currency) * of.concepts) / of.cues) : sum
  }, 0)

/** What an hour of the whole work earns, in minor units; null without hours. */
export function perHourOf(typed: TypedBid, currency: string): number | null {
  const hours = hundredthsOf(typed.hours)
  return hours ? Math.round((totalOf(typed, currency) * 100) / hours) : null
}
