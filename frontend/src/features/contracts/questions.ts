/** The five questions that a draft is written from: which clauses answer each, and what stands there in words. */
import { percent } from '@/money/words'
import { plural } from '@/ui/format'

import type { Clause, Contract, Draft, LibraryClause, Version } from './api'
import { termsOf } from './clauses'

export const QUESTIONS = ['who', 'what', 'price', 'rounds', 'rights'] as const
export type Question = (typeof QUESTIONS)[number]

export const QUESTION_NAMES: Record<Question, string> = {
  who: 'Who',
  what: 'What',
  price: 'Price and schedule',
  rounds: 'Rounds of changes',
  rights: 'Rights',
}

/** The clauses that say the answer; all others are usual unless somebody changed them. */
export const ANSWERED_BY: Record<Question, readonly string[]> = {
  who: ['parties'],
  what: ['services'],
  price: ['payment_plan'],
  rounds: ['rounds', 'rates'],
  rights: ['ownership', 'ownership_on_creation', 'reel'],
}

export interface Problem {
  where: string
  message: string
}

/** Whether a contract orders work, and so has sounds, a price and a schedule. */
export const isOrder = ({ kind }: Pick<Contract, 'kind'>): boolean => kind === 'single' || kind === 'statement_of_work'

/** The questions of a contract: an NDA asks for no price, and a text without rounds for none. */
export const questionsOf = (contract: Contract, library: readonly LibraryClause[]): Question[] =>
  QUESTIONS.filter((question) =>
    question === 'who'
      ? true
      : question === 'what' || question === 'price'
        ? isOrder(contract)
        : ANSWERED_BY[question].some((key) =>
            [...contract.version.clauses, ...library].some((clause) => clause.key === key),
          ),
  )

/** The question that a fault of the text belongs to; null where it is one of the whole text. */
export function questionOf({ where }: Problem, draft: Draft, library: readonly LibraryClause[]): Question | null {
  const [kind, key = ''] = where.split('.')
  const named = (clauseKey: string) =>
    draft.clauses.some(
      (clause) =>
        clause.key === clauseKey &&
        termsOf(
          clause,
          library.find(({ key: known }) => known === clauseKey),
          draft.terms,
        ).includes(key),
    )
  return (
    QUESTIONS.find((question) =>
      ANSWERED_BY[question].some((clauseKey) => (kind === 'clauses' ? clauseKey === key : named(clauseKey))),
    ) ?? null
  )
}

/** Whether somebody changed a clause, or a value of it, since the draft was begun. */
export function isChanged(
  clause: Clause,
  begun: Pick<Version, 'clauses' | 'terms'>,
  draft: Draft,
  known?: LibraryClause,
) {
  const before = begun.clauses.find(({ key }) => key === clause.key)
  if (!before || !before.stands || before.title !== clause.title || before.text !== clause.text) return true
  return termsOf(clause, known, draft.terms).some((name) => draft.terms[name] !== begun.terms[name])
}

const stands = (draft: Draft, key: string) => draft.clauses.some((clause) => clause.key === key && clause.stands)

export function saysWho({ studio_name, signers, designer }: Contract): string {
  const names = signers.map(({ name }) => name)
  const signing =
    names.length === 0 ? 'any producer signs' : `${names.join(' and ')} ${names.length === 1 ? 'signs' : 'sign'}`
  return `${studio_name} (${signing}) and ${designer.name}`
}

export function saysRounds(draft: Draft): string {
  if (!stands(draft, 'rounds')) return 'The text says nothing of rounds.'
  const { rounds_included: rounds, extra_round_bp: extra, silence_days: days } = draft.terms
  const further = stands(draft, 'rates') && typeof extra === 'number' ? `; a further one costs ${percent(extra)}` : ''
  const silence = stands(draft, 'silence')
    ? `Silence of ${plural(Number(days), 'working day')} accepts.`
    : 'No acceptance by silence.'
  return `${plural(Number(rounds ?? 0), 'round')} included${further}. ${silence}`
}

export function saysRights(draft: Draft, designer: string): string {
  const passes = stands(draft, 'ownership_on_creation')
    ? 'All rights pass on creation'
    : stands(draft, 'ownership')
      ? 'All rights pass with payment'
      : 'Rights pass as your own clauses say'
  return `${passes}; ${designer} ${stands(draft, 'reel') ? 'may show the work' : 'may not show the work'}.`
}
