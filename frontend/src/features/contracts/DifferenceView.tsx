import { amount, money } from '@/money/words'
import { plural, shortDay } from '@/ui/format'

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
      <ul className={classes.changes}>
        {difference.changes.map((change) => (
          <li key={change}>{change}</li>
        ))}
      </ul>
      <dl className={classes.ba}>
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
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a region that scrolls is reached by keys */}
      <div className={classes.table} tabIndex={0} role="region" aria-label="Payment plan">
        <table>
          <thead className="dim">
            <tr>
              <th scope="col">{`Payment plan, ${currency}`}</th>
              <th scope="col" className={classes.number}>
                now
              </th>
              <th scope="col" className={classes.number}>
                after
              </th>
            </tr>
          </thead>
          <tbody>
            {difference.milestones.map((one) => (
              <tr key={one.name}>
                <td>
                  {one.name} <span className="mid">{datesOf(one)}</span>
                </td>
                <td className={classes.number}>{amount(one.amount_before_minor, currency)}</td>
                <td className={classes.number}>
                  {one.amount_before_minor === one.amount_after_minor ? (
                    'same'
                  ) : (
                    <strong>{amount(one.amount_after_minor, currency)}</strong>
                  )}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
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
