import { money, percent } from '@/money/words'
import { day, dueDay } from '@/ui/format'
import type { StateKind } from '@/ui/StatusBadge'

import type { ContractBrief, ContractKind, Entry } from './api'

export const KIND_WORDS: Record<ContractKind, string> = {
  nda: 'Non-disclosure agreement',
  framework: 'Framework agreement',
  statement_of_work: 'Statement of work',
  single: 'Contract',
}

export const KIND_MEANINGS: Record<ContractKind, string> = {
  single: 'one contract for everything',
  framework: 'rights and rates agreed once, for many batches of work',
  statement_of_work: 'one batch under a framework agreement: cues, price, dates',
  nda: 'keeps what you share before a contract confidential',
}

export const KINDS = Object.keys(KIND_MEANINGS) as ContractKind[]
export const isKind = (value: string | null): value is ContractKind => KINDS.some((kind) => kind === value)

/** How a contract stands, and who is next. */
export function progress(contract: ContractBrief): { kind: StateKind; text: string } {
  const mine = contract.my_party !== null && contract.waits_for.includes(contract.my_party)
  switch (contract.state) {
    case 'draft':
      return { kind: 'waiting', text: mine ? 'Draft, with you' : 'Draft, with the studio' }
    case 'sent':
      if (mine) return { kind: 'to_review', text: 'Needs your signature' }
      if (contract.waits_for.length === 0) return { kind: 'waiting', text: 'Signed, waiting for the joint contract' }
      return { kind: 'waiting', text: `Waiting for the ${contract.waits_for.join(' and the ')} to sign` }
    case 'agreed':
      if (contract.notice) {
        const { ends_on: last } = contract.notice
        return { kind: 'warning', text: last ? `Signed, ends ${dueDay(last)}` : 'Signed, notice given' }
      }
      return { kind: 'accepted', text: contract.agreed_at ? `Signed ${day(contract.agreed_at)}` : 'Agreed' }
    case 'ended':
      return { kind: 'cut', text: contract.ended_at ? `Ended ${day(contract.ended_at)}` : 'Ended' }
  }
}

/** A term's label where the library has none: its name in words. */
export const inWords = (name: string): string => {
  const words = name.replace(/_(bp|minor)$/, '').replaceAll('_', ' ')
  return words.charAt(0).toUpperCase() + words.slice(1)
}

/** A value of a term as the text says it. */
export function figureInWords(
  name: string,
  value: number | string,
  currency: string,
  choices: readonly { value: number | string; label: string }[] = [],
): string {
  const choice = choices.find((each) => each.value === value)
  if (choice) return choice.label
  if (typeof value === 'string') return value
  if (name.endsWith('_bp')) return percent(value)
  return name.endsWith('_minor') ? money(value, currency) : String(value)
}

/** How the address of the accepting person was verified. */
export const PROOF_WORDS = {
  mail: 'verified by email',
  operator: 'verified by a link from the server’s administrator',
  provider: 'verified by the sign-in provider of a studio',
  none: 'email not verified',
} as const

const EVENT_WORDS: Record<string, string> = {
  sent: 'Sent to both parties',
  taken_back: 'Recalled',
  change_requested: 'Change requested',
  redlines_proposed: 'Redlines proposed',
  redline_answered: 'Redline answered',
  accepted_by: 'Accepted',
  agreed: 'Agreed',
  stands_alone: 'No longer joint work',
  ended: 'Ended',
  offer_dismissed: 'No change order wanted',
  change_proposed: 'Change order proposed',
  change_accepted: 'Change order signed',
  change_refused: 'Change order refused',
  change_withdrawn: 'Change order withdrawn',
  change_lapsed: 'Change order lapsed',
  changed: 'Change order in force',
  notice_given: 'Notice given',
  notice_withdrawn: 'Notice withdrawn',
  statement_accepted: 'Settlement statement accepted',
  settled: 'Settled',
  planned: 'Plan agreed',
  adopted: 'Accepted earlier, added to the contract',
  reminded: 'Reminder to review',
  delivered: 'Delivered',
  judged: 'Reviewed',
  moved_away: 'Moved to another cue',
  handed_off: 'Cue handed off',
  continued_by: 'Cue continued by another designer',
  taken_over: 'Cue taken over',
  source_file: 'Source file kept',
  source_file_removed: 'Source file removed',
  returned: 'Returned by a later check',
  conforms_again: 'Passed a later check',
  waived: 'Waived',
  accepted: 'Cue accepted',
  due: 'Due',
  paid: 'Paid',
  cut: 'Cut',
  invoiced: 'Invoiced',
  refunded: 'Refunded',
  sealed: 'Sealed',
  masters_end_announced: 'Deletion of masters announced',
  masters_end_postponed: 'Deletion of masters postponed',
  masters_deleted: 'Masters deleted',
  masters_kept_longer: 'Masters kept longer',
  masters_not_kept_longer: 'Masters no longer kept longer',
  written: 'Data recorded',
}

/** An entry of the record as a sentence. */
export const eventOf = ({ kind }: Entry): string => EVENT_WORDS[kind] ?? inWords(kind)

const QUIET = new Set([
  'by',
  'by_email',
  'role',
  'on_behalf_of',
  'text_sha256',
  'text_sha256_of_amendment',
  'pdf_sha256',
  'consent',
  'rows', // of the tables, for `soundlist verify`; the entry says in words what happened
])

/** The author of an entry: name, role at that time, and on whose behalf. */
export function authorOf({ payload: { by, role, on_behalf_of: behalf } }: Entry): string {
  if (typeof by !== 'string') return ''
  const inRole = typeof role === 'string' ? ` (${role})` : ''
  return ` by ${by}${inRole}${typeof behalf === 'string' ? ` for ${behalf}` : ''}`
}

/** The facts of an entry, name and value, but for who and for hashes. */
export function factsOf({ payload }: Entry): { name: string; value: string }[] {
  return Object.entries(payload)
    .filter(([name, value]) => !QUIET.has(name) && value !== '' && value !== null)
    .map(([name, value]) => ({
      name: inWords(name),
      value: valueInWords(value),
    }))
}

/** Milestones and the like in words: "First batch, amount 1,200.00 EUR, cues 3; Second batch, …". */
function valueInWords(value: unknown): string {
  if (Array.isArray(value)) return value.map(valueInWords).join('; ')
  if (typeof value !== 'object' || value === null) return String(value)
  return Object.entries(value)
    .filter(([, one]) => one !== '' && one !== null)
    .map(([name, one]) => (name === 'name' ? valueInWords(one) : `${inWords(name).toLowerCase()} ${valueInWords(one)}`))
    .join(', ')
}
