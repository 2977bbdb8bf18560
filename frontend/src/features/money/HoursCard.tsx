import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { type ContractMoney, daysQuery, type Hours } from '@/money/api'
import { hours, money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { plural, shortDay } from '@/ui/format'
import { Rows } from '@/ui/Rows'
import { Table } from '@/ui/Table'

import { HoursForm } from './HoursForm'
import { WorkRow } from './WorkRow'

interface HoursCardProps {
  contract: ContractMoney
  projectId: string
  side: 'team' | 'designer'
  isProducer: boolean
}

/** Work by the hour and a retainer: the designer logs hours, a producer agrees, and they are due up to the caps. */
export function HoursCard({ contract, projectId, side, isProducer }: HoursCardProps) {
  const { by_hour: terms, currency, title, contract_id: contractId } = contract
  const { data: logged = [] } = useQuery({ ...daysQuery(contractId), enabled: terms !== null })
  const [correcting, setCorrecting] = useState<string | null>(null)
  if (terms === null) return null
  const entries = logged.filter(({ minutes }) => minutes !== null)
  const corrected = entries.find(({ id, state }) => id === correcting && state !== 'agreed')
  return (
    <Card aria-label={`Hours, ${title}`}>
      <CardHead
        id={`hours-${contractId}`}
        title="Hours"
        count={entries.length > 0 ? entries.length : undefined}
        end={inWords(terms, currency)}
      />
      {terms.months.length > 0 && <Months terms={terms} title={title} />}
      {entries.length === 0 && (
        <div className="p-3-inset">
          <EmptyState head="No hours logged yet" level={3}>
            {side === 'designer'
              ? 'Log hours after you worked them. They count once the studio agrees to them.'
              : 'The designer logs hours worked. They count once you agree to them, up to the caps.'}
          </EmptyState>
        </div>
      )}
      <Rows>
        {entries.toReversed().map((entry) => (
          <WorkRow
            key={entry.id}
            work={entry}
            length={hours(entry.minutes ?? 0)}
            currency={currency}
            side={side}
            isProducer={isProducer}
            onCorrect={() => setCorrecting(entry.id)}
          />
        ))}
      </Rows>
      {side === 'designer' && (
        <HoursForm
          key={corrected?.id ?? 'new'}
          contract={contract}
          projectId={projectId}
          corrected={corrected}
          onDone={() => setCorrecting(null)}
        />
      )}
    </Card>
  )
}

/** "$900.00 a month for 6 months with 2 h; $60.00 an hour, 5 h at most, 1 h used". */
function inWords(terms: Hours, currency: string): string {
  const { retainer_minor: retainer, retainer_months: months, included_min: included, rate_minor: rate } = terms
  const parts = []
  if (retainer > 0)
    parts.push(`${money(retainer, currency)} a month for ${plural(months, 'month')} with ${hours(included)}`)
  if (rate > 0) {
    const caps = `${hours(terms.month_cap_min)} a month and ${hours(terms.cap_min)} in all at most`
    parts.push(`${money(rate, currency)} an hour, ${caps}, ${hours(terms.paid_min)} used`)
  }
  return parts.join('; ')
}

function Months({ terms, title }: { terms: Hours; title: string }) {
  return (
    <Table
      label={`Hours by month, ${title}`}
      rows={terms.months.toReversed()}
      keyOf={({ number }) => number}
      columns={[
        {
          head: 'Month from',
          rowHead: true,
          cell: (month) => (
            <>
              {shortDay(month.begins_on)}
              {month.is_retained && <span className="mid">, retainer</span>}
            </>
          ),
        },
        { head: 'Agreed', numeric: true, cell: (month) => hours(month.approved_min) },
        { head: 'Waiting', numeric: true, cell: (month) => hours(month.waiting_min) },
        { head: 'Left', numeric: true, cell: (month) => hours(month.left_min) },
      ]}
    />
  )
}
