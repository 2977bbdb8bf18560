import type { LedgerLine } from '@/money/api'
import { amount } from '@/money/words'
import { shortDay } from '@/ui/format'
import { Table } from '@/ui/Table'

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
    <Table
      label={name}
      rows={lines.toReversed()}
      keyOf={({ id }) => id}
      columns={[
        { head: 'Day', cell: ({ at }) => <span className="nowrap">{shortDay(at)}</span> },
        {
          head: 'Type',
          cell: (line) => (
            <>
              {KINDS[line.kind]}
              {line.round_number !== null && ` ${line.round_number}`}
              {line.reference !== null && `, ${line.reference}`}
              {line.invoice_number !== null && <span className="dim"> invoice {line.invoice_number}</span>}
            </>
          ),
        },
        { head: 'For', cell: ({ cue, milestone }) => cue?.name ?? milestone ?? '' },
        { head: 'Clause', wideOnly: true, cell: ({ clause }) => clause.replaceAll('_', ' ') },
        { head: 'By', wideOnly: true, cell: ({ by }) => by },
        { head: currency, numeric: true, cell: ({ amount_minor: minor }) => amount(minor, currency) },
      ]}
    />
  )
}
