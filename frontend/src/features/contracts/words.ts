import { ApiProblem } from '@/api'
import { day } from '@/ui/format'
import type { StateKind } from '@/ui/State'

import type { ContractBrief, ContractKind, Entry } from './api'

export const KIND_WORDS: Record<ContractKind, string> = {
  nda: 'Non-disclosure agreement',
  framework: 'Framework agreement',
  statement_of_work: 'Statement of work',
  single: 'Contract',
}

export const KIND_MEANINGS: Record<ContractKind, string> = {
  single: 'one text that holds all of it',
  framework: 'rights and rates once, for many batches',
  statement_of_work: 'one batch under a framework: cues, price, dates',
  nda: 'what is shown before a contract stays between you',
}

export const KINDS = Object.keys(KIND_MEANINGS) as ContractKind[]
export const isKind = (value: string | null): value is ContractKind => KINDS.some((kind) => kind === value)

/** How a contract stands, and who is next. */
export function standing(contract: ContractBrief): { kind: StateKind; text: string } {
  const mine = contract.my_party !== null && contract.waits_for.includes(contract.my_party)
  switch (contract.state) {
    case 'draft':
      return { kind: 'waiting', text: mine ? 'Draft, with you' : 'Draft, with the studio' }
    case 'sent':
      if (mine) return { kind: 'to_review', text: 'Waits for your yes' }
      return { kind: 'waiting', text: `Waits for the ${contract.waits_for.join(' and the ')}` }
    case 'agreed':
      return { kind: 'accepted', text: contract.agreed_at ? `Agreed ${day(contract.agreed_at)}` : 'Agreed' }
    case 'ended':
      return { kind: 'cut', text: contract.ended_at ? `Ended ${day(contract.ended_at)}` : 'Ended' }
  }
}

/** Sentences of the server begin small where they follow a name. */
export const sentence = (text: string): string => {
  const begun = text.charAt(0).toUpperCase() + text.slice(1)
  return /[.?!]$/.test(begun) ? begun : `${begun}.`
}

export function refusal(error: unknown): { detail: string; fix?: string } {
  if (!(error instanceof ApiProblem)) return { detail: 'The page itself broke while sending. Nothing typed is lost.' }
  return { detail: sentence(error.detail), fix: error.fix === '' ? undefined : sentence(error.fix) }
}

/** A term's label where the library has none: its name in words. */
export const inWords = (name: string): string => {
  const words = name.replace(/_(bp|minor)$/, '').replaceAll('_', ' ')
  return words.charAt(0).toUpperCase() + words.slice(1)
}

/** How it was shown that whoever accepted reads the mail of their address. */
export const PROOF_WORDS = {
  mail: 'proven by a link mailed there',
  operator: 'proven by a link that the server’s operator handed over',
  none: 'address not proven',
} as const

const EVENT_WORDS: Record<string, string> = {
  sent: 'Sent to both parties',
  taken_back: 'Taken back',
  change_asked: 'Change asked for',
  accepted_by: 'Accepted',
  agreed: 'Agreed',
  ended: 'Ended',
  planned: 'Plan fixed',
  adopted: 'Accepted before, and taken in',
  reminded: 'Reminded of a verdict',
  delivered: 'Delivered',
  judged: 'Judged',
  moved_away: 'Moved to another cue',
  returned: 'Held back by a later check',
  conforms_again: 'Conforms again',
  waived: 'Let through by a waiver',
  accepted: 'Cue accepted',
  due: 'Due',
  paid: 'Paid',
  cut: 'Cut',
  invoiced: 'Invoiced',
  refunded: 'Refunded',
}

/** What an entry of the record tells, in words. */
export const eventOf = ({ kind }: Entry): string => EVENT_WORDS[kind] ?? inWords(kind)

const QUIET = new Set(['by', 'by_email', 'role', 'on_behalf_of', 'text_sha256', 'pdf_sha256'])

/** Who did what an entry tells: name, role at that time, and on whose behalf. */
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
      value: typeof value === 'object' ? JSON.stringify(value) : String(value as string | number | boolean),
    }))
}
