import { useQuery } from '@tanstack/react-query'
import type { LinkProps } from '@tanstack/react-router'
import { Link } from '@tanstack/react-router'

import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { dueDay, plural } from '@/ui/format'

import { type ContractMoney, moneyQuery } from './api'
import classes from './Money.module.css'
import { amount, money, percent } from './words'

/** What a designer is owed and for which cues, and what is due next from them. */
export function OwedCards({ projectId }: { projectId: string }) {
  const { data } = useQuery(moneyQuery(projectId))
  return (
    <>
      {data?.contracts.map((contract) => (
        <Owed key={contract.contract_id} contract={contract} projectId={projectId} />
      ))}
      {data?.contracts.map((contract) => (
        <DueCards key={contract.contract_id} contract={contract} />
      ))}
    </>
  )
}

interface Sum {
  text: string
  minor: number
}

/** The amounts that a contract owes now: accepted cues together, each cut cue by itself. */
function sumsOf({ milestones, kill_fee_in_work_bp: inWorkBp }: ContractMoney): Sum[] {
  const cues = milestones.flatMap((milestone) => milestone.cues)
  const unpaid = cues.filter(({ owed_minor, paid_minor }) => owed_minor !== paid_minor)
  const accepted = unpaid.filter(({ cut_in }) => cut_in === null)
  const sums: Sum[] = milestones
    .filter(({ is_deposit, owed_minor, paid_minor }) => is_deposit && owed_minor !== paid_minor)
    .map(({ name, owed_minor, paid_minor }) => ({ text: name, minor: owed_minor - paid_minor }))
  if (accepted.length > 0) {
    const text = accepted.map(({ cue }) => cue.name).join(', ')
    sums.push({ text, minor: accepted.reduce((sum, row) => sum + row.owed_minor - row.paid_minor, 0) })
  }
  for (const row of unpaid.filter(({ cut_in }) => cut_in !== null)) {
    const how = row.cut_in === 'in_work' ? `cut in progress, ${percent(inWorkBp)}` : 'cut'
    sums.push({ text: `${row.cue.name}, ${how}`, minor: row.owed_minor - row.paid_minor })
  }
  return sums
}

function Owed({ contract, projectId }: { contract: ContractMoney; projectId: string }) {
  const { currency, figures, release, proposed_rounds: rounds, billable_minor: billable } = contract
  const id = `owed-${contract.contract_id}`
  return (
    <Card aria-labelledby={id}>
      <CardHead id={id} title="You are owed" end={release === 'per_cue' ? 'paid per cue' : 'paid per milestone'} />
      <div className="grid gap-1 p-3-inset">
        <p className={classes.figure}>{money(figures.due_minor, currency)}</p>
        {sumsOf(contract).map(({ text, minor }) => (
          <p key={text} className="grid wrap-anywhere grid-cols-1-auto gap-0-3">
            <span className="mid">{text}</span> <span>{amount(minor, currency)}</span>
          </p>
        ))}
        {rounds.map((round) => (
          <p key={round.id} className="small mid">
            {round.cue.name}, round {round.number} of {round.included}: waiting until the studio agrees to{' '}
            {money(round.amount_minor, currency)}.
          </p>
        ))}
        <div className="flex wrap items-center gap-2-3 mt-2">
          {billable !== 0 && (
            <ButtonLink component={Link} to={`/projects/${projectId}/money` as LinkProps['to']}>
              Draft invoice {contract.next_invoice}
            </ButtonLink>
          )}
          <span className="small mid">
            Paid {amount(figures.paid_minor, currency)}
            {contract.last_days_to_pay !== null &&
              `; last ${contract.last_days_to_pay === 0 ? 'on the day of the invoice' : `after ${plural(contract.last_days_to_pay, 'day')}`}`}
          </span>
        </div>
      </div>
    </Card>
  )
}

function DueCards({ contract }: { contract: ContractMoney }) {
  return contract.milestones
    .filter(({ is_deposit, done_at, wanted }) => !is_deposit && done_at === null && wanted > 0)
    .map((milestone) => {
      const id = `due-${milestone.id}`
      const left = milestone.cues.filter(({ accepted_at, cut_in }) => accepted_at === null && cut_in === null)
      return (
        <Card key={milestone.id} aria-labelledby={id}>
          <CardHead
            id={id}
            title={milestone.due_on === null ? milestone.name : `Due ${dueDay(milestone.due_on)}`}
            end={`${milestone.name}, ${milestone.accepted} of ${milestone.wanted}`}
          />
          <p className="mid wrap-anywhere p-2-inset">{left.map(({ cue }) => cue.name).join(', ')}</p>
        </Card>
      )
    })
}
