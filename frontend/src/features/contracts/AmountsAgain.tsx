import { TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { planQuery } from '@/money/api'
import { amount, minorOf, money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { ErrorBanner } from '@/ui/ErrorBanner'

import type { Draft } from './api'
import classes from './Contracts.module.css'

interface AmountsAgainProps {
  contractId: string
  /** The currency of the amounts so far. */
  before: string
  draft: Draft
  /** What is typed so far, by milestone. */
  typed: Readonly<Record<string, string>>
  onChange: (typed: Record<string, string>) => void
}

/** The amounts of the plan, to be entered again where a draft changes its currency: nothing is converted. */
export function AmountsAgain({ contractId, before, draft, typed, onChange }: AmountsAgainProps) {
  const { data: plan } = useQuery(planQuery(contractId))
  return (
    <Card aria-labelledby="amounts-again">
      <CardHead id="amounts-again" title={`Amounts in ${draft.currency}`} />
      <div className={classes.form}>
        <ErrorBanner
          detail={`Nothing is converted from ${before}.`}
          fix={`Enter each amount again in ${draft.currency}, here and in the clauses, or keep ${before}.`}
        />
        {plan?.milestones
          .filter(({ amount_minor: minor }) => minor > 0)
          .map(({ id, name, amount_minor: minor }) => (
            <TextInput
              key={id}
              label={`${name}, ${draft.currency}`}
              description={`so far ${money(minor, before)}`}
              value={typed[id] ?? ''}
              inputMode="decimal"
              error={
                typed[id] && minorOf(typed[id], draft.currency) === null
                  ? `“${typed[id]}” is not an amount in ${draft.currency}. Write it like ${amount(144_000, draft.currency)}.`
                  : undefined
              }
              onChange={({ currentTarget: { value } }) => onChange({ ...typed, [id]: value })}
            />
          ))}
      </div>
    </Card>
  )
}

/** The amounts as they are sent; the server names those that are missing or cannot be read. */
export function amountsOf(
  typed: Readonly<Record<string, string>>,
  currency: string,
): { milestone_id: string; amount_minor: number }[] {
  return Object.entries(typed).flatMap(([id, text]) => {
    const minor = /^[A-Z]{3}$/.test(currency) ? minorOf(text, currency) : null
    return minor === null ? [] : [{ milestone_id: id, amount_minor: minor }]
  })
}
