import { amount, money } from '@/money/words'
import { plural, shortDay } from '@/ui/format'
import { Table } from '@/ui/Table'

import type { Difference } from './api'
import classes from './Contracts.module.css'
import { Warning } from './Warning'

/** Scope, price and dates before and after, and what that does to the plan. */
export function DifferenceView({ difference, currency }: { difference: Difference; currency: string }) {
  const {
    cues_before: cues,
    cues_after: cuesAfter,
    price_before_minor: price,
    price_after_minor: priceAfter,
  } = difference
  return (
    <>
      <ul className={` ${classes.changes}`}>
        {difference.changes.map((change) => (
          <li key={change}>{change}</li>
        ))}
      </ul>
      <dl className={`grid gap-2px-4 ${classes.ba}`}>
        <dt>Scope</dt>
        <dd>
          {cues === cuesAfter ? (
            plural(cues, 'cue')
          ) : (
            <>
              {plural(cues, 'cue')} → <strong>{plural(cuesAfter, 'cue')}</strong>
            </>
          )}
        </dd>
        <dt>Price</dt>
        <dd>
          {price === priceAfter ? (
            money(price, currency)
          ) : (
            <>
              {amount(price, currency)} → <strong>{money(priceAfter, currency)}</strong>{' '}
              <span className="mid">{`${priceAfter > price ? '+' : '−'} ${amount(Math.abs(priceAfter - price), currency)}`}</span>
            </>
          )}
        </dd>
      </dl>
      <Table
        label="Payment plan"
        rows={difference.milestones}
        keyOf={({ name }) => name}
        columns={[
          {
            head: `Payment plan, ${currency}`,
            cell: (milestone) => (
              <>
                {milestone.name} <span className="mid">{datesOf(milestone)}</span>
              </>
            ),
          },
          { head: 'now', numeric: true, cell: ({ amount_before_minor: before }) => amount(before, currency) },
          {
            head: 'after',
            numeric: true,
            cell: ({ amount_before_minor: before, amount_after_minor: after }) =>
              before === after ? 'same' : <strong>{amount(after, currency)}</strong>,
          },
        ]}
      />
      {[...difference.warnings, ...difference.advice].map(({ code, message, why }) => (
        <Warning key={`${code} ${message}`}>{`${message} ${why}`}</Warning>
      ))}
      {difference.advice_gone.map(({ message }) => (
        <Warning key={message} good>{`No longer so: ${message}`}</Warning>
      ))}
    </>
  )
}

const datesOf = (one: Difference['milestones'][number]): string => {
  if (one.is_deposit) return 'at signing'
  const [before, after] = [one.due_before, one.due_after].map((due) => (due === null ? 'no date' : shortDay(due)))
  return before === after ? (before ?? '') : `${before} → ${after}`
}
