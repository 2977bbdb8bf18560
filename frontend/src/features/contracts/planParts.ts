/** The parts of a plan as a draft's question shows them: plain functions of plain values; the server proposes and checks. */
import type { Plan, PlanProposal, PlanSet } from '@/money/api'

export type Part = Required<PlanSet['milestones'][number]> & { amount_minor: number }

export const partsOfPlan = ({ milestones }: Plan): Part[] =>
  milestones.map(({ name, due_on, amount_minor, is_deposit, tax_bp, cues }) => ({
    ...{ name, due_on, amount_minor, is_deposit, tax_bp },
    cues: cues.map(({ cue, price_minor, estimate_min }) => ({ cue_id: cue.id, price_minor, estimate_min })),
  }))

export const partsOfProposal = ({ milestones }: PlanProposal): Part[] =>
  milestones.map(({ name, due_on, amount_minor, is_deposit, cue_ids }) => ({
    ...{ name, due_on, is_deposit, amount_minor: amount_minor ?? 0, tax_bp: null },
    cues: cue_ids.map((cue_id) => ({ cue_id, price_minor: null, estimate_min: null })),
  }))

export const totalOf = (parts: readonly Part[]): number =>
  parts.reduce((sum, { amount_minor }) => sum + amount_minor, 0)

/** A part of the price in basis points. */
export const shareBp = ({ amount_minor }: Part, totalMinor: number): number =>
  totalMinor === 0 ? 0 : Math.round((amount_minor * 10_000) / totalMinor)

/** The parts with one of them at another share of the price; prices of single cues no longer add up to it. */
export const withShare = (parts: readonly Part[], place: number, bp: number, totalMinor: number): Part[] =>
  parts.map((part, at) =>
    at === place
      ? {
          ...part,
          amount_minor: Math.round((totalMinor * bp) / 10_000),
          cues: part.cues.map((cue) => ({ ...cue, price_minor: null })),
        }
      : part,
  )

export const withDay = (parts: readonly Part[], place: number, dueOn: string): Part[] =>
  parts.map((part, at) => (at === place ? { ...part, due_on: dueOn === '' ? null : dueOn } : part))

/** Everything paid when the last sound is accepted. */
export const onePayment = (parts: readonly Part[], totalMinor: number): Part[] => [
  {
    ...{ name: 'All sounds', is_deposit: false, amount_minor: totalMinor, tax_bp: null },
    due_on: parts.reduce<string | null>(
      (last, { due_on }) => (due_on && (!last || due_on > last) ? due_on : last),
      null,
    ),
    cues: parts.flatMap(({ cues }) => cues.map((cue) => ({ ...cue, price_minor: null }))),
  },
]
