import { day, dueDay, figure, length, place, plural, range } from '@/ui/format'

import type { QueueCount, QueueItem, ReviewCue, ReviewFinding, ReviewTake } from './api'
import { inOrder, letterOf, outlierOf, variationName } from './hearing'

/** A sentence of the checker as the screens write it: a capital first, a true minus before figures. */
export function sentence(text: string): string {
  const written = text.replace(/(^|[\s(])-(?=\d|∞|inf)/g, '$1−')
  return written.charAt(0).toUpperCase() + written.slice(1)
}

/** Reasons as sentences, after what they are of: "Fits the scene. Best timing." */
export const reasonsText = (reasons: readonly string[]): string => reasons.map((reason) => `${reason}.`).join(' ')

/** The text of an entry of the history: the checker's words as a sentence; reasons, names and people's texts unchanged. */
export const historyText = ({
  kind,
  text,
  reasons = [],
}: {
  kind: string
  text: string
  reasons?: string[]
}): string => (kind === 'checked' ? sentence(text) : [reasonsText(reasons), text].filter(Boolean).join(' '))

/** What a finding measured: up to the comma that begins its limit. */
export function measuredPart(finding: ReviewFinding): [measured: string, rest: string] {
  const message = sentence(finding.message)
  const comma = message.indexOf(', ')
  return comma < 0 ? [message, ''] : [message.slice(0, comma), message.slice(comma)]
}

export interface Waits {
  before: string
  /** What stands out, coloured. */
  odd: string
  after: string
}

/** What waits of a cue, in one line. */
export function describeWaiting(item: QueueItem): Waits {
  const plain = (before: string): Waits => ({ before, odd: '', after: '' })
  if (item.kind === 'set') {
    const here = new Set(item.takes.map(({ variation }) => variation)).size
    const whole = item.cue.variations
    const set = here === whole ? `Set of ${whole}` : `${here} of a set of ${whole}`
    const odd = outlierOf(item.takes)
    if (odd) {
      const words = `${variationName(odd.take.variation)} is ${figure(Math.abs(odd.awayDb), 1)} dB ${odd.awayDb > 0 ? 'louder' : 'quieter'}`
      return { before: `${set}: `, odd: words, after: ' than the others' }
    }
    if (item.worst_finding) return withFinding(`${set}: `, item.worst_finding)
    return plain(`${set}, all conforming`)
  }
  if (item.kind === 'alternates') {
    const many = `${item.takes.length} alternates, pick one`
    return item.worst_finding ? withFinding(`${many}: `, item.worst_finding) : plain(many)
  }
  const number = Math.max(1, ...item.takes.map((take) => take.number))
  const version = number === 1 ? 'First version' : `Version ${number}`
  if (item.worst_finding) return withFinding(`${version}: `, item.worst_finding)
  return plain(number > 1 && item.last_change ? `${version}, after “${item.last_change}”` : `${version}, conforming`)
}

function withFinding(before: string, finding: ReviewFinding): Waits {
  const [odd, after] = measuredPart(finding)
  return { before, odd, after }
}

const SMALL_NUMBERS = [
  'none',
  'one',
  'two',
  'three',
  'four',
  'five',
  'six',
  'seven',
  'eight',
  'nine',
  'ten',
  'eleven',
  'twelve',
]

/** "three", "14": small numbers as words, as in a sentence. */
export const spelled = (count: number): string => SMALL_NUMBERS[count] ?? figure(count)

/** As a badge says it: "12", and "99+" where not all are counted. */
export const counted = ({ cues, is_all }: QueueCount): number | string => (is_all ? cues : `${cues}+`)

export const capital = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1)

/** What is to be done with a cue: "Pick one of three for shield_hit". */
export function asks(item: QueueItem): string {
  const { name, variations } = item.cue
  if (item.kind === 'alternates') return `Pick one of ${spelled(item.takes.length)} for ${name}`
  if (item.kind === 'set') return `Listen to the set of ${spelled(variations)} for ${name}`
  const number = Math.max(1, ...item.takes.map((take) => take.number))
  return number > 1 ? `Review version ${number} of ${name}` : `Review ${name}`
}

const REVERB_WORDS: Record<string, string> = {
  dry: 'dry',
  'designed-tail': 'designed tail',
  'separate-tail': 'separate tail file',
}

/** The facts that were asked for: "Weapon, one-shot, 0.80 s wanted, no reverb in the file". */
export function asked(cue: ReviewCue): string {
  const facts = [
    cue.category,
    cue.loop ? 'loop' : 'one-shot',
    cue.variations > 1 ? `set of ${cue.variations}` : '',
    cue.duration_s === null ? '' : `target ${length(cue.duration_s)}`,
    cue.channels ?? '',
    cue.reverb === null ? '' : (REVERB_WORDS[cue.reverb] ?? ''),
  ]
  return capital(facts.filter(Boolean).join(', '))
}

/** The label of a take next to its cue: "A", "_03", "_03 B", "version 2". */
export function takeName(take: ReviewTake, cue: ReviewCue, waiting: readonly ReviewTake[]): string {
  const ofVariation = waiting.filter(({ variation }) => variation === take.variation)
  const letter = ofVariation.length > 1 ? letterOf(take, waiting) : ''
  const variation = cue.variations > 1 ? variationName(take.variation) : ''
  const name = [variation, letter].filter(Boolean).join(' ')
  if (name !== '' && ofVariation.some(({ id }) => id === take.id)) return name
  return [variation, `version ${take.number}`].filter(Boolean).join(' ')
}

/** Where in a sound something was said: "0.307–0.462 s", "0.044 s", or nothing for the whole of it. */
export function spot(startS: number | null | undefined, endS: number | null | undefined): string | undefined {
  if (startS === null || startS === undefined) return undefined
  return endS === null || endS === undefined || endS === startS ? place(startS) : range(startS, endS)
}

/** "shield_hit", "shield_hit and suit_hit", "shield_hit, suit_hit and 3 more". */
export function namesOf(names: readonly string[]): string {
  const own = [...new Set(names)]
  if (own.length > 3) return `${own.slice(0, 2).join(', ')} and ${plural(own.length - 2, 'more', 'more')}`
  return own.length < 2 ? (own[0] ?? '') : `${own.slice(0, -1).join(', ')} and ${own.at(-1)}`
}

/** The takes of an item in the order in which they are heard. */
export const heardTakes = (item: QueueItem): ReviewTake[] => inOrder(item.takes)

const HAPPENED: Record<string, string> = {
  received: 'Delivered',
  checked: 'Checked',
  waived: 'Waived',
  approve: 'Approved',
  set_aside: 'Set aside',
  request_change: 'Change requested',
  withdraw: 'Decision undone',
  comment: 'Comment',
  labelled: 'Labelled',
}

/** What happened to a take, in a word or two. */
export const happened = ({
  kind,
  by_deemed_acceptance: bySilence,
  by_adoption: byAdoption,
  without_listening: isUnheard,
}: {
  kind: string
  by_deemed_acceptance?: boolean
  by_adoption?: boolean
  without_listening?: boolean
}): string => {
  if (kind === 'approve' && bySilence) return 'Auto-accepted (no response)'
  if (kind === 'approve' && byAdoption) return 'Adopted'
  if (kind === 'approve' && isUnheard) return 'Approved without listening'
  return HAPPENED[kind] ?? kind
}

interface Named {
  name: string
}

/** Who did what happened to a take, and for whom where a deputy did it. */
export const byWhom = ({ by, on_behalf_of: absent }: { by: Named | null; on_behalf_of?: Named | null }): string =>
  [by?.name, absent && `for ${absent.name}`].filter(Boolean).join(' ')

/** Until when a cue waits under its contract's clause on silence. */
const PAUSED_BY = {
  question: 'the designer’s question is open',
  change_order: 'a change order is open',
  undecided_versions: 'one delivery has several files for the same place, and nobody chose',
} as const

/** The day after which silence accepts; while something is open its days do not count. */
export const deemedAcceptanceNotice = (after: string, pausedBy: keyof typeof PAUSED_BY | null = null): string =>
  pausedBy === null
    ? `auto-accepted after ${day(after)} if nobody responds`
    : `auto-acceptance is paused: ${PAUSED_BY[pausedBy]}`

const SOON_MS = 4 * 86_400_000

/** Whether a day is so near that every line in a queue should say it. */
export const isSoon = (on: string, now: Date = new Date()): boolean => Date.parse(on) - now.getTime() < SOON_MS

/** Why a cue comes first in the queue: others wait for it. */
export const urgencyReason = ({ palette, due_on: dueOn }: ReviewCue, now: Date = new Date()): string =>
  [palette ? 'palette' : '', dueOn === null ? '' : `due ${dueDay(dueOn, now)}`].filter(Boolean).join(', ')
