import { TextInput } from '@mantine/core'
import { keepPreviousData, useQuery, useQueryClient } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { type Plan, planCheckQuery, proposedPlanQuery, useSavePlan } from '@/money/api'
import { EffortLine } from '@/money/EffortLine'
import { amount, minorOf, money, percent } from '@/money/words'
import { Button, ButtonLink } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'
import { useDebounced } from '@/ui/useDebounced'

import { TermField } from './ClauseFields'
import contractClasses from './Contracts.module.css'
import classes from './Draft.module.css'
import { FigureField } from './FigureField'
import { onePayment, type Part, partsOfPlan, partsOfProposal, shareBp, totalOf, withDay, withShare } from './planParts'
import type { Drafting } from './useDrafting'

interface TypedPrice {
  price: string
  /** The parts as they were edited; null: those that are suggested, or saved. */
  parts: Part[] | null
}

/** The price that is typed and the parts that it is paid in: saved, suggested by the server, or edited here. */
export function usePrice({ contract, draft }: Drafting, plan: Plan) {
  const client = useQueryClient()
  const { currency } = draft
  const saved = partsOfPlan(plan)
  const savedMinor = totalOf(saved)
  const firstMinor = savedMinor || (plan.price.bid_currency === currency ? (plan.price.bid_minor ?? 0) : 0)
  const [typed, setTyped, kept] = useDraft<TypedPrice>(`price:${contract.id}:${savedMinor}`, () => ({
    price: firstMinor > 0 ? amount(firstMinor, currency) : '',
    parts: null,
  }))
  const totalMinor = minorOf(typed.price, currency)
  const isSaved = typed.parts === null && savedMinor > 0 && totalMinor === savedMinor && currency === contract.currency
  const askedMinor = useDebounced(totalMinor)
  const proposal = useQuery({
    ...proposedPlanQuery(contract.id, askedMinor),
    enabled: askedMinor !== null && askedMinor > 0 && typed.parts === null && !isSaved,
    placeholderData: keepPreviousData,
  })
  const suggested = proposal.data ? partsOfProposal(proposal.data) : []
  const parts = typed.parts ?? (isSaved ? saved : suggested)
  const checked = useQuery({
    ...planCheckQuery(contract.id, { milestones: parts }),
    enabled: parts.length > 0 && !isSaved,
    placeholderData: keepPreviousData,
  })
  return {
    typed,
    setTyped,
    kept,
    totalMinor,
    parts,
    isSaved,
    advice: isSaved ? plan.advice : (checked.data?.advice ?? []),
    faults: isSaved ? [] : (checked.data?.faults ?? []),
    price: isSaved ? plan.price : checked.data?.price,
    isEmpty: proposal.data?.milestones.length === 0,
    error: proposal.error ?? checked.error,
    /** The parts of the price as it is typed now, whether or not they were suggested yet. */
    partsNow: async () =>
      typed.parts ??
      (isSaved || totalMinor === null
        ? parts
        : partsOfProposal(await client.fetchQuery(proposedPlanQuery(contract.id, totalMinor)))),
  }
}

export type Price = ReturnType<typeof usePrice>

interface PriceQuestionProps {
  drafting: Drafting
  price: Price
  plan: Plan
  back: string
  onUsed: () => void
}

/** What is paid, in which parts and by when: a suggestion that our own checks have nothing against, and room to differ. */
export function PriceQuestion({ drafting, price, plan, back, onUsed }: PriceQuestionProps) {
  const { contract, draft, setDraft, library, isOtherCurrency, save } = drafting
  const { typed, setTyped, totalMinor, parts, isSaved, advice, faults } = price
  const { currency } = draft
  const client = useQueryClient()
  const savePlan = useSavePlan(contract.id)
  const [isUsing, setUsing] = useState(false)
  const isRead = typed.price.trim() === '' || (totalMinor !== null && totalMinor > 0)
  const missingMinor = typed.parts ? (totalMinor ?? 0) - totalOf(parts) : 0 // a suggestion is made for the price
  const apply = async () => {
    if (isUsing || totalMinor === null || missingMinor !== 0) return
    setUsing(true)
    try {
      const milestones = await price.partsNow()
      // Another currency converts nothing: the old amounts go before the new ones come.
      const emptied = plan.milestones.map(({ id }) => ({ milestone_id: id, amount_minor: 0 }))
      if (milestones.length === 0 || (isOtherCurrency && !(await save(emptied)))) return
      await savePlan.mutateAsync({ milestones })
      await invalidate(client, queryKeys.money('plan', contract.id), queryKeys.contract(contract.id))
      price.kept.discard()
      showToast('Plan used. Text and invoices read it.')
      onUsed()
    } catch {
      // said below
    } finally {
      setUsing(false)
    }
  }
  const submit = (event: FormEvent) => {
    event.preventDefault()
    void apply()
  }
  if (draft.terms.price_mode === 'day_rate') {
    return (
      <div className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}>
        <p>The price comes from the days worked, up to a number of them.</p>
        {['day_rate_minor', 'days_cap'].map((name) => (
          <TermField
            key={name}
            name={name}
            known={library.flatMap(({ terms }) => terms).find((term) => term.name === name)}
            value={draft.terms[name] ?? 0}
            currency={currency}
            onChange={(value) => setDraft((now) => ({ ...now, terms: { ...now.terms, [name]: value } }))}
          />
        ))}
        <EditPlan back={back} />
      </div>
    )
  }
  return (
    <form
      className={`grid grid-cols-1 gap-3 justify-items-start ${classes.body}`}
      onSubmit={submit}
      noValidate
      aria-label="Price and schedule"
    >
      <div className={`grid gap-2 w-full ${classes.pair}`}>
        <TextInput
          label="Price, deposit included"
          id="draft-price"
          value={typed.price}
          inputMode="decimal"
          error={isRead ? undefined : `“${typed.price}” is not an amount in ${currency}. Write it like 6,000.00.`}
          onChange={({ currentTarget: { value } }) => setTyped({ price: value, parts: null })}
        />
        <TextInput
          label="Currency"
          value={currency}
          maxLength={3}
          onChange={({ currentTarget: { value } }) => {
            setDraft((now) => ({ ...now, currency: value.toUpperCase() }))
            setTyped({ price: '', parts: null })
          }}
        />
      </div>
      <BesideBid price={price} plan={plan} currency={currency} />
      {isOtherCurrency && (
        <p className="small tone-warn">
          {`Nothing is converted from ${contract.currency}: enter the price again, and read the amounts in other clauses.`}
        </p>
      )}
      {price.isEmpty && (
        <p className="small mid" role="status">
          Every cue of the list is cut, or is under an agreed contract.
        </p>
      )}
      {parts.length > 0 && (
        <>
          <div className={`flex between gap-2 ${classes.planHead}`}>
            <h3>{typed.parts ? 'Your plan' : isSaved ? 'Plan' : 'Suggested plan'}</h3>
            {advice.length === 0 && faults.length === 0 && missingMinor === 0 && (
              <StatusBadge kind="passed">No warnings</StatusBadge>
            )}
          </div>
          <Parts
            parts={parts}
            advice={advice}
            totalMinor={totalMinor ?? 0}
            currency={currency}
            onChange={(next) => setTyped((now) => ({ ...now, parts: next }))}
          />
          {missingMinor !== 0 && (
            <p className="tone-bad" role="alert">
              {`The parts come to ${money(totalOf(parts), currency)}, ${money(Math.abs(missingMinor), currency)} ${missingMinor > 0 ? 'less' : 'more'} than the price. Change a share.`}
            </p>
          )}
          {[...advice.filter(({ subject }) => !parts.some(({ name }) => name === subject)), ...faults].map(
            ({ message }) => (
              <p key={message} className="small tone-warn">
                {message}
              </p>
            ),
          )}
          {!typed.parts && !isSaved && (
            <p className="small mid">
              Each part is at most 30 % of the price where that many are possible, due two weeks or more after the one
              before, and none is larger than the last. The deposit is part of the price.
            </p>
          )}
        </>
      )}
      <EffortLine projectId={contract.project_id} contractId={contract.id} dueOn={lastDay(parts)} />
      <Refusal error={price.error ?? savePlan.error} />
      <div className={contractClasses.buttons}>
        {!isSaved && (
          <Button
            type="submit"
            variant="primary"
            keys="Enter"
            aria-busy={isUsing}
            disabled={!totalMinor || missingMinor !== 0 || price.isEmpty}
          >
            Use this plan
          </Button>
        )}
        {parts.length > 1 && totalMinor !== null && (
          <Button onClick={() => setTyped((now) => ({ ...now, parts: onePayment(parts, totalMinor) }))}>
            One payment at the end
          </Button>
        )}
        {typed.parts && <Button onClick={() => setTyped((now) => ({ ...now, parts: null }))}>Suggest again</Button>}
        <EditPlan back={back} />
      </div>
    </form>
  )
}

/** The last day on which a part is due; empty where no part has one. */
const lastDay = (parts: readonly Part[]): string =>
  parts.reduce((last, { due_on: dueOn }) => (dueOn && dueOn > last ? dueOn : last), '')

const EditPlan = ({ back }: { back: string }) => (
  <ButtonLink component={Link} variant="quiet" to={`${back}/plan`}>
    Edit plan
  </ButtonLink>
)

function BesideBid({ price: { price, totalMinor }, plan, currency }: { price: Price; plan: Plan; currency: string }) {
  const { bid_minor: bidMinor, bid_currency: bidCurrency } = price ?? plan.price
  if (bidMinor === null || !totalMinor) return null
  if (bidCurrency !== currency)
    return <p className="small mid">{`The bid is ${money(bidMinor, bidCurrency ?? currency)}.`}</p>
  const above = totalMinor - bidMinor
  if (above === 0) return <StatusBadge kind="passed">{`The same as the bid, ${money(bidMinor, currency)}`}</StatusBadge>
  return (
    <StatusBadge kind="warning">
      {`${money(Math.abs(above), currency)} ${above > 0 ? 'more' : 'less'} than the bid of ${money(bidMinor, currency)}`}
    </StatusBadge>
  )
}

interface PartsProps {
  parts: readonly Part[]
  advice: readonly { subject: string; message: string }[]
  totalMinor: number
  currency: string
  onChange: (parts: Part[]) => void
}

function Parts({ parts, advice, totalMinor, currency, onChange }: PartsProps) {
  return (
    <table className={`w-full ${classes.parts}`} aria-label="Parts of the price">
      <thead>
        <tr>
          <th scope="col">Part</th>
          <th scope="col">When</th>
          <th scope="col" className="num">
            Share
          </th>
          <th scope="col" className="num">
            {currency}
          </th>
        </tr>
      </thead>
      <tbody>
        {parts.map((part, place) => (
          <tr key={place}>
            <th scope="row">
              {part.is_deposit ? part.name : `${part.name}, ${plural(part.cues.length, 'sound')}`}
              {advice
                .filter(({ subject }) => subject === part.name)
                .map(({ message }) => (
                  <span key={message} className="small tone-warn">
                    {message}
                  </span>
                ))}
            </th>
            <td>
              {part.is_deposit ? (
                'at signing'
              ) : (
                <input
                  type="date"
                  className={classes.figure}
                  aria-label={`${part.name}: due on`}
                  value={part.due_on ?? ''}
                  onChange={({ currentTarget }) => onChange(withDay(parts, place, currentTarget.value))}
                />
              )}
            </td>
            <td className="num">
              <FigureField
                name="share_bp"
                known={{ name: 'share_bp', label: `${part.name}: share`, default: 0, min: 0, max: 10_000, choices: [] }}
                text={percent(shareBp(part, totalMinor))}
                value={shareBp(part, totalMinor)}
                currency={currency}
                onChange={(value) => onChange(withShare(parts, place, Number(value), totalMinor))}
              />
            </td>
            <td className="num">{amount(part.amount_minor, currency)}</td>
          </tr>
        ))}
      </tbody>
      <tfoot>
        <tr>
          <th scope="row">Total</th>
          <td />
          <td className="num">{percent(totalMinor === 0 ? 0 : Math.round((totalOf(parts) * 10_000) / totalMinor))}</td>
          <td className="num">{amount(totalOf(parts), currency)}</td>
        </tr>
      </tfoot>
    </table>
  )
}
