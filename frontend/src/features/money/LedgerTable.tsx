import type { LedgerLine } from '@/money/api'
import { amount } from '@/money/words'
import { shortDay } from '@/ui/format'

import classes from './Page.module.css'

const KINDS = {
  deposit: 'Deposit',
  accepted: 'Accepted',
  held_back: 'Retention',
  cut: 'Cut',
  extra_round: 'Extra round',
  worked_day: 'Day worked',
  worked_hours: 'Hours worked',
  retainer: 'Retainer',
  extra_work: 'Extra work',
  late_interest: 'Late interest',
  bonus: 'Bonus',
  tax: 'Tax',
  reversed: 'Reversed',
  paid: 'Paid',
  refunded: 'Refunded',
}

/** Lines of a ledger, the newest first. */
export function LedgerTable({
  lines,
  currency,
  name,
}: {
  lines: readonly LedgerLine[]
  currency: string
  name: string
}) {
  return (
    // A region that scrolls is reached by the keyboard.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
    <div className={classes.scroll} tabIndex={0} role="region" aria-label={name}>
      <table className={`small ${classes.table}`}>
        <thead className="dim">
          <tr>
            <th scope="col">Day</th>
            <th scope="col">Type</th>
            <th scope="col">For</th>
            <th scope="col" className={classes.wideOnly}>
              Clause
            </th>
            <th scope="col" className={classes.wideOnly}>
              By
            </th>
            <th scope="col" className={classes.number}>
              {currency}
            </th>
          </tr>
        </thead>
        <tbody>
          {lines.toReversed().map((line) => (
            <tr key={line.id}>
              <td>{shortDay(line.at)}</td>
              <td>
                {KINDS[line.kind]}
                {line.round_number !== null && ` ${line.round_number}`}
                {line.reference !== null && `, ${line.reference}`}
                {line.invoice_number !== null && <span className="dim"> invoice {line.invoice_number}</span>}
              </td>
              <td>{line.cue?.name ?? line.milestone ?? ''}</td>
              <td className={classes.wideOnly}>{line.clause.replaceAll('_', ' ')}</td>
              <td className={classes.wideOnly}>{line.by}</td>
              <td className={classes.number}>{amount(line.amount_minor, currency)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  )
}
