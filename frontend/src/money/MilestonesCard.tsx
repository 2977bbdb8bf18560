import { Link, type LinkProps } from '@tanstack/react-router'
import { type ReactNode, useId } from 'react'

import { Card, CardHead } from '@/ui/Card'
import { dueDay, shortDay } from '@/ui/format'

import type { ContractMoney, MilestoneMoney, Slip } from './api'
import classes from './Money.module.css'
import { money, slipInWords } from './words'

interface MilestonesCardProps {
  contracts: readonly ContractMoney[]
  projectId: string
  side: 'team' | 'designer'
  end?: ReactNode
  /** The contract, where each has a card of its own. */
  of?: string
}

/** How far each milestone is, counted in accepted cues. */
export function MilestonesCard({ contracts, projectId, side, end = 'by accepted cues', of }: MilestonesCardProps) {
  const id = useId()
  const rows = contracts.flatMap((contract) =>
    contract.milestones
      .filter(({ is_deposit }) => !is_deposit)
      .map((milestone) => ({
        milestone,
        currency: contract.currency,
        slip: contract.slips.find(({ milestone_id }) => milestone_id === milestone.id),
      })),
  )
  if (rows.length === 0) return null
  return (
    <Card aria-label={of === undefined ? 'Milestones' : `Milestones, ${of}`}>
      <CardHead id={id} title="Milestones" end={end} />
      <ul aria-labelledby={id}>
        {rows.map(({ milestone, currency, slip }) => (
          <li key={milestone.id} className={`grid items-center border-b ${classes.milestone}`}>
            <Link className="link strong" to={`/projects/${projectId}/milestones/${milestone.id}` as LinkProps['to']}>
              {milestone.name}
            </Link>
            <span className={`overflow-hidden ${classes.progress}`} aria-hidden="true">
              <span style={{ width: `${(100 * milestone.accepted) / Math.max(1, milestone.wanted)}%` }} />
            </span>
            <span className="num">
              {milestone.accepted} of {milestone.wanted}
            </span>
            <span className={`small flex wrap gap-0-2 ${classes.when}`}>
              <span className="dim">{when(milestone)}</span>
              <span className="mid">{slip && slip.days > 0 ? slipInWords(slip, side) : progress(milestone, slip)}</span>
            </span>
            <span className="small num">{money(milestone.left_minor, currency)}</span>
          </li>
        ))}
      </ul>
    </Card>
  )
}

function when({ due_on: due, done_at: done }: MilestoneMoney): string {
  if (due === null) return 'no date'
  return done === null ? dueDay(due) : shortDay(due)
}

function progress(
  { done_at: done, owed_minor: owed, paid_minor: paid }: MilestoneMoney,
  slip: Slip | undefined,
): string {
  if (done === null) return ''
  return `accepted ${slip ? 'on time ' : ''}${owed > 0 && paid >= owed ? 'and paid' : ''}`.trim()
}
