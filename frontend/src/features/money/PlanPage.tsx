import { keepPreviousData, useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { useMemo } from 'react'

import { contractQuery } from '@/api/project'
import { keptCuesQuery } from '@/api/soundList'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import {
  planQuery,
  planCheckQuery,
  type Contract,
  type ListedCue,
  type Plan,
  type PlanChecked,
  useSavePlan,
} from '@/money/api'
import { conceptWords, money } from '@/money/words'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { PageWait } from '@/ui/PageWait'
import { useDebounced } from '@/ui/useDebounced'

import classes from './Plan.module.css'
import {
  type Fault,
  NO_CUE,
  paysMinor,
  planOf,
  type TypedCue,
  typedOf,
  type TypedPlan,
  typedProposal,
  withDeposit,
} from './plan'
import { PlannedCues } from './PlannedCues'
import { PlannedMilestones } from './PlannedMilestones'
import { ProposePlan } from './ProposePlan'

/** The plan of a draft: milestones with dates and amounts, which cues they cover, and the warnings about it. */
export function PlanPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/plan' })
  const { data: contract, error } = useQuery(contractQuery(contractId))
  const { data: plan, error: noPlan } = useQuery({ ...planQuery(contractId), staleTime: Infinity })
  const { data: cues, error: noCues } = useQuery(keptCuesQuery(projectId))
  useTitle(contract ? `Plan: ${contract.title}` : 'Plan')
  const problem = error ?? noPlan ?? noCues
  if (contract && !contract.may.change) return <Fixed contract={contract} projectId={projectId} />
  if (!contract || !plan || !cues) {
    return <PageWait title="Plan" error={problem} />
  }
  return <Editor key={contractId} contract={contract} plan={plan} cues={cues} projectId={projectId} />
}

function Fixed({ contract, projectId }: { contract: Contract; projectId: string }) {
  const params = { projectId, contractId: contract.id }
  return (
    <div className="page page-narrow">
      <EmptyState
        head={contract.state === 'agreed' ? 'The plan is agreed' : 'You can’t edit this plan'}
        level={1}
        action={
          <Link className="link" to="/projects/$projectId/contracts/$contractId" params={params}>
            Back to {contract.title}
          </Link>
        }
      >
        {contract.state === 'agreed'
          ? 'Both sides signed these dates and amounts. To add work, create another statement of work. See Money for the state of each milestone.'
          : 'Producers edit the plan while the contract is a draft. Recall a sent contract before editing it.'}
      </EmptyState>
    </div>
  )
}

interface EditorProps {
  contract: Contract
  plan: Plan
  cues: readonly ListedCue[]
  projectId: string
}

function Editor({ contract, plan, cues, projectId }: EditorProps) {
  const navigate = useNavigate()
  const save = useSavePlan(contract.id)
  const begun = useMemo(() => typedOf(plan), [plan])
  const [typed, setTyped, draft] = useDraft<TypedPlan>(`plan:${contract.id}`, begun)
  const { currency } = contract
  const { plan: typedPlan, faults: unread } = planOf(typed, cues, currency)
  const settled = useDebounced(typed)
  const looked = useQuery({
    ...planCheckQuery(
      contract.id,
      useMemo(() => planOf(settled, cues, currency).plan, [settled, cues, currency]),
    ),
    placeholderData: keepPreviousData,
  })
  const faults: Fault[] = [...unread, ...(looked.data?.faults ?? [])]
  const isChanged = JSON.stringify(typed) !== JSON.stringify(begun) && !save.isSuccess

  const add = () =>
    setTyped((now) => ({
      ...now,
      milestones: [
        ...now.milestones,
        { key: crypto.randomUUID(), name: '', dueOn: '', amount: '', tax: '', isDeposit: false },
      ],
    }))
  const change = (ids: readonly string[], changes: Partial<TypedCue>) =>
    setTyped((now) => ({
      ...now,
      cues: {
        ...now.cues,
        ...Object.fromEntries(ids.map((id) => [id, { ...(now.cues[id] ?? NO_CUE), ...changes }])),
      },
    }))
  useHotkeys([{ keys: 'n', label: 'Add milestone', group: 'Plan', run: add }])

  const params = { projectId, contractId: contract.id }
  const keep = () => {
    if (save.isPending || unread.length > 0) return
    save.mutate(typedPlan, {
      onSuccess: () => {
        draft.discard()
        showToast('Plan saved. The contract text is updated.')
        void navigate({ to: '/projects/$projectId/contracts/$contractId', params })
      },
    })
  }
  return (
    <div className="page stack">
      <header className={`flex wrap top between ${classes.head}`}>
        <div>
          <h1>{`Plan: ${contract.title}`}</h1>
          <p className="mid">{modeInWords(contract)}</p>
          {timeInWords(contract) && <p className="mid">{timeInWords(contract)}</p>}
        </div>
        <div className="flex wrap gap-2">
          <ButtonLink
            component={Link}
            to={`/projects/${projectId}/contracts/${contract.id}`}
            onClick={isChanged ? draft.discard : undefined}
          >
            {isChanged ? 'Discard changes' : 'Back to contract'}
          </ButtonLink>
          <Button
            variant="primary"
            disabled={!isChanged || unread.length > 0}
            aria-busy={save.isPending}
            onClick={keep}
          >
            Save plan
          </Button>
        </div>
      </header>
      <DraftNote draft={draft} />
      <Refusal error={save.error} />
      <div className="columns">
        <div className="stack">
          <PlannedMilestones
            milestones={typed.milestones}
            pays={typedPlan.milestones.map(paysMinor)}
            faults={faults}
            currency={currency}
            onChange={(milestones) => setTyped((now) => ({ ...now, milestones }))}
            onAdd={add}
            begin={
              <ProposePlan
                contractId={contract.id}
                currency={currency}
                isByDay={contract.version.terms.price_mode === 'day_rate'}
                onProposed={(proposal) => setTyped(typedProposal(proposal, currency))}
              />
            }
          />
          <PlannedCues cues={cues} typed={typed} currency={currency} projectId={projectId} onChange={change} />
        </div>
        <aside className="stack" aria-label="Plan total">
          <Sums
            contract={contract}
            pays={typedPlan.milestones}
            bid={looked.data?.price}
            concepts={looked.data?.concepts}
            onDeposit={() => setTyped((now) => withDeposit(now, typedPlan.milestones.map(paysMinor), currency))}
          />
          <Advice
            faults={faults.filter(({ where }) => where === 'milestones')}
            advice={looked.data?.advice ?? []}
            isEmpty={typed.milestones.length === 0}
            error={looked.error}
          />
        </aside>
      </div>
    </div>
  )
}

/** The pricing model, as the draft's terms say it. */
function modeInWords({ version, currency }: Contract): string {
  const { price_mode: mode, day_rate_minor: rate, days_cap: cap } = version.terms
  if (mode === 'day_rate') {
    return `By the day: ${money(Number(rate ?? 0), currency)} a day, ${plural(Number(cap ?? 0), 'day')} at most. Milestones here are dates only; they need no amount.`
  }
  return mode === 'per_cue'
    ? 'Per cue: a milestone’s amount is the sum of its cues’ prices.'
    : 'A milestone’s amount is split among its cues by price, or equally if they have none. Without an amount, it is the sum of their prices.'
}

/** What the clauses on hours and a retainer pay beside the plan; empty where neither is included. */
function timeInWords({ version, currency }: Contract): string {
  const includes = (clause: string) => version.clauses.some(({ key, stands }) => key === clause && stands)
  const of = (name: string) => Number(version.terms[name] ?? 0)
  const parts = []
  if (includes('retainer')) {
    const months = plural(of('retainer_months'), 'month')
    parts.push(`a retainer of ${money(of('retainer_minor'), currency)} for each of ${months}`)
  }
  if (includes('hours')) {
    const cap = plural(of('hours_cap'), 'hour')
    parts.push(`work at ${money(of('hour_rate_minor'), currency)} an hour, up to ${cap}`)
  }
  return parts.length > 0 ? `Beside the milestones this contract pays ${parts.join(' and ')}.` : ''
}

/** How a price compares with the bid. */
function beside(price: number, bid: number, bidCurrency: string, currency: string): string {
  if (bidCurrency !== currency) return `the price is in ${currency}`
  if (price === bid) return 'the price is the same'
  return `the price is ${money(Math.abs(price - bid), currency)} ${price > bid ? 'above' : 'below'} it`
}

interface SumsProps {
  contract: Contract
  pays: ReturnType<typeof planOf>['plan']['milestones']
  bid?: PlanChecked['price']
  concepts?: PlanChecked['concepts']
  onDeposit: () => void
}

/** The price, with the deposit in it, beside the bid that the contract began from. */
function Sums({ contract, pays, bid, concepts, onDeposit }: SumsProps) {
  const sum = (isDeposit: boolean) =>
    pays
      .filter(({ is_deposit }) => (is_deposit ?? false) === isDeposit)
      .reduce((all, milestone) => all + paysMinor(milestone), 0)
  const [deposit, milestones] = [sum(true), sum(false)]
  const price = deposit + milestones
  const bidMinor = bid?.bid_minor ?? null
  const bidCurrency = bid?.bid_currency ?? contract.currency
  return (
    <Card aria-labelledby="sums">
      <CardHead id="sums" title="Price" end="excluding tax" />
      <div className="p-3-inset">
        <p className="figure">{money(price, contract.currency)}</p>
        <p className="small mid">
          {`${money(deposit, contract.currency)} of it at signing, ${money(milestones, contract.currency)} by milestones.`}
        </p>
        {bidMinor !== null && (
          <p className="small">
            {`The bid is ${money(bidMinor, bidCurrency)}: ${beside(price, bidMinor, bidCurrency, contract.currency)}.`}
          </p>
        )}
        {concepts !== undefined && concepts.count > 0 && (
          <p className="small tone-warn">{conceptWords(concepts, contract.currency)}</p>
        )}
        {deposit === 0 && milestones > 0 && <Button onClick={onDeposit}>Make 20 % of the price the deposit</Button>}
      </div>
    </Card>
  )
}

interface AdviceProps {
  /** Of the whole plan; those of a milestone are next to it. */
  faults: readonly Fault[]
  advice: readonly { code: string; message: string; why: string }[]
  isEmpty: boolean
  error: Error | null
}

function Advice({ faults, advice, isEmpty, error }: AdviceProps) {
  return (
    <Card aria-labelledby="advice">
      <CardHead
        id="advice"
        title="Warnings"
        count={advice.length > 0 ? advice.length : undefined}
        end="you can still send"
      />
      <div className="p-3-inset" aria-live="polite">
        <Refusal error={error} />
        {faults.map(({ message }) => (
          <ErrorBanner key={message} detail={message} />
        ))}
        {advice.length === 0 && faults.length === 0 && (
          <p className="mid">
            {isEmpty
              ? 'No milestones yet.'
              : 'No warnings: payments rise, the last is the largest, and every milestone has a date.'}
          </p>
        )}
        <ul className="grid gap-3">
          {advice.map(({ code, message, why }) => (
            <li key={`${code} ${message}`}>
              <p className="tone-warn">{message}</p>
              <p className="small mid">{why}</p>
            </li>
          ))}
        </ul>
      </div>
    </Card>
  )
}
