import type { ListedCue, Plan, PlanProposal, PlanSet } from '@/money/api'
import { amount, minorOf } from '@/money/words'

/** A milestone as it is typed; its key lasts as long as the page. */
export interface TypedMilestone {
  key: string
  name: string
  dueOn: string
  amount: string
  tax: string
  isDeposit: boolean
}

/** What is typed for a cue; without a milestone the contract does not cover it. */
export interface TypedCue {
  milestone: string
  price: string
  hours: string
}

export interface TypedPlan {
  milestones: TypedMilestone[]
  cues: Readonly<Record<string, TypedCue>>
}

export interface Fault {
  /** `milestones.0` is the first one. */
  where: string
  message: string
}

export const NO_CUE: TypedCue = { milestone: '', price: '', hours: '' }

/** What was saved, as fields show it. */
export function typedOf({ milestones, currency }: Plan): TypedPlan {
  const cues: Record<string, TypedCue> = {}
  for (const { id, cues: own } of milestones) {
    for (const { cue, price_minor: price, estimate_min: estimate } of own) {
      cues[cue.id] = {
        milestone: id,
        price: price === null ? '' : amount(price, currency),
        hours: estimate === null ? '' : String(Number((estimate / 60).toFixed(2))),
      }
    }
  }
  return {
    cues,
    milestones: milestones.map((milestone) => {
      const isPriced = milestone.cues.length > 0 && milestone.cues.every(({ price_minor }) => price_minor !== null)
      return {
        key: milestone.id,
        name: milestone.name,
        dueOn: milestone.due_on ?? '',
        amount: isPriced ? '' : amount(milestone.amount_minor, currency),
        tax: milestone.tax_bp === null ? '' : String(milestone.tax_bp / 100),
        isDeposit: milestone.is_deposit,
      }
    }),
  }
}

/** What was proposed, as fields show it; nothing of it is saved yet. */
export function typedProposal({ milestones }: PlanProposal, currency: string): TypedPlan {
  const keyed = milestones.map((milestone) => ({ ...milestone, key: crypto.randomUUID() }))
  return {
    milestones: keyed.map(({ key, name, due_on: dueOn, amount_minor: minor, is_deposit: isDeposit }) => ({
      key,
      name,
      dueOn: dueOn ?? '',
      amount: minor === null ? '' : amount(minor, currency),
      tax: '',
      isDeposit,
    })),
    cues: Object.fromEntries(
      keyed.flatMap(({ key, cue_ids: ids }) => ids.map((id) => [id, { ...NO_CUE, milestone: key }])),
    ),
  }
}

const bounded = (typed: string, scale: number, most: number): number | null => {
  const value = Number(typed.trim().replace(',', '.'))
  return Number.isFinite(value) && value >= 0 && value <= most ? Math.round(value * scale) : null
}

/** The plan to send, and what of the typing cannot be read; what cannot be read is left out of it. */
export function planOf(
  typed: TypedPlan,
  list: readonly ListedCue[],
  currency: string,
): { plan: PlanSet; faults: Fault[] } {
  const faults: Fault[] = []
  const read = <T>(text: string, value: T | null, where: string, message: string): T | null => {
    if (text.trim() === '') return null
    if (value === null) faults.push({ where, message })
    return value
  }
  const positive = (text: string): number | null => {
    const minor = minorOf(text, currency)
    return minor !== null && minor >= 0 ? minor : null
  }
  const milestones = typed.milestones.map((milestone, place) => {
    const where = `milestones.${place}`
    if (milestone.name.trim() === '') faults.push({ where, message: 'Enter a name.' })
    const called = milestone.name.trim() || `Milestone ${place + 1}`
    const cues = milestone.isDeposit
      ? []
      : list.flatMap((cue) => {
          const typedCue = typed.cues[cue.id]
          if (typedCue?.milestone !== milestone.key) return []
          const price = read(
            typedCue.price,
            positive(typedCue.price),
            where,
            `${cue.name}: “${typedCue.price}” is not an amount in ${currency}. Write it like 180.00.`,
          )
          const minutes = read(
            typedCue.hours,
            bounded(typedCue.hours, 60, 10_000),
            where,
            `${cue.name}: “${typedCue.hours}” is not a number of hours. Write it like 2 or 1.5.`,
          )
          return [{ cue_id: cue.id, price_minor: price, estimate_min: minutes || null }]
        })
    return {
      name: called,
      due_on: milestone.isDeposit || milestone.dueOn === '' ? null : milestone.dueOn,
      is_deposit: milestone.isDeposit,
      amount_minor: read(
        milestone.amount,
        positive(milestone.amount),
        where,
        `“${milestone.amount}” is not an amount in ${currency}. Write it like 1,440.00.`,
      ),
      tax_bp: read(
        milestone.tax,
        bounded(milestone.tax, 100, 100),
        where,
        `“${milestone.tax}” is not a tax rate. Enter 0 to 100, such as 19.`,
      ),
      cues,
    }
  })
  return { plan: { milestones }, faults }
}

/** What a milestone pays: its amount, else the prices of its cues. */
export const paysMinor = ({ amount_minor, cues }: PlanSet['milestones'][number]): number =>
  amount_minor ?? (cues ?? []).reduce((sum, { price_minor }) => sum + (price_minor ?? 0), 0)

/** Whole parts of a sum by their weights; what is left after rounding down goes to the last one. */
function shares(sum: number, weights: readonly number[]): number[] {
  const whole = weights.reduce((all, weight) => all + weight, 0)
  const parts = weights.map((weight) => (whole === 0 ? 0 : Math.floor((weight * sum) / whole)))
  const left = sum - parts.reduce((all, part) => all + part, 0)
  return parts.map((part, at) => (at === parts.length - 1 ? part + left : part))
}

/** The plan with a fifth of its price as its deposit: the price stays, and the other amounts are lowered by as much. */
export function withDeposit(typed: TypedPlan, pays: readonly number[], currency: string): TypedPlan {
  const total = pays.reduce((all, minor) => all + minor, 0)
  const deposit = Math.ceil(total / 5)
  const others = typed.milestones.flatMap((item, at) => (item.isDeposit ? [] : [{ item, minor: pays[at] ?? 0 }]))
  const lowered = shares(
    total - deposit,
    others.map(({ minor }) => minor),
  )
  const cues: Record<string, TypedCue> = { ...typed.cues }
  const milestones = others.map(({ item }, at) => {
    const minor = lowered[at] ?? 0
    if (item.amount.trim() !== '') return { ...item, amount: amount(minor, currency) }
    const own = Object.entries(typed.cues).filter(([, { milestone }]) => milestone === item.key)
    const prices = shares(
      minor,
      own.map(([, { price }]) => minorOf(price, currency) ?? 0),
    )
    own.forEach(([id, cue], place) => (cues[id] = { ...cue, price: amount(prices[place] ?? 0, currency) }))
    return item
  })
  const first = typed.milestones.find(({ isDeposit }) => isDeposit)
  const kept = first ?? { key: crypto.randomUUID(), name: 'Deposit', dueOn: '', tax: '' }
  return { cues, milestones: [{ ...kept, amount: amount(deposit, currency), isDeposit: true }, ...milestones] }
}

/** The list with one of its places exchanged with its neighbour; the same list at its ends. */
export function moved<T>(items: readonly T[], place: number, by: 1 | -1): T[] {
  const result = [...items]
  const [item, neighbour] = [result[place], result[place + by]]
  if (item === undefined || neighbour === undefined) return result
  result[place] = neighbour
  result[place + by] = item
  return result
}
