import { NativeSelect } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { DraftForm } from '@/app/drafts/DraftForm'
import { daysQuery, type ContractMoney, useLogDay } from '@/money/api'
import { amount, money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Field, Submit } from '@/ui/Form'
import { today } from '@/ui/format'
import { Rows } from '@/ui/Rows'

import classes from './Page.module.css'
import { WorkRow } from './WorkRow'

const QUARTERS = ['Quarter day', 'Half day', 'Three quarters of a day', 'Full day']
const CHOICES = QUARTERS.map((label, place) => ({ value: String(place + 1), label })).toReversed()

interface DaysCardProps {
  contract: ContractMoney
  side: 'team' | 'designer'
  isProducer: boolean
}

/** The days of a contract by the day: its designer logs them, a producer agrees, and they are due up to the cap. */
export function DaysCard({ contract, side, isProducer }: DaysCardProps) {
  const { by_day: byDay, currency, title, contract_id: contractId } = contract
  const { data: logged = [] } = useQuery({ ...daysQuery(contractId), enabled: byDay !== null })
  if (byDay === null) return null
  const days = logged.filter(({ quarters }) => quarters !== null)
  const { day_rate_minor: rate, days_cap: cap, agreed_minor: agreed, cap_minor: most } = byDay
  return (
    <Card aria-label={`Days, ${title}`}>
      <CardHead
        id={`days-${contractId}`}
        title="Days"
        count={days.length > 0 ? days.length : undefined}
        end={`${amount(agreed, currency)} of ${money(most, currency)}; ${money(rate, currency)} a day, ${cap} at most`}
      />
      {days.length === 0 && (
        <div className="p-3-inset">
          <EmptyState head="No days logged yet" level={3}>
            {side === 'designer'
              ? 'Log a day after you worked it. It is due once the studio agrees to it.'
              : 'The designer logs days worked. Each is due once you agree to it, up to the cap.'}
          </EmptyState>
        </div>
      )}
      <Rows>
        {days.toReversed().map((entry) => (
          <WorkRow
            key={entry.id}
            work={entry}
            length={QUARTERS[(entry.quarters ?? 1) - 1]?.toLowerCase() ?? ''}
            currency={currency}
            side={side}
            isProducer={isProducer}
          />
        ))}
      </Rows>
      {side === 'designer' && <LogForm contract={contract} />}
    </Card>
  )
}

function LogForm({ contract: { contract_id: id, title } }: { contract: ContractMoney }) {
  const log = useLogDay(id)
  return (
    <DraftForm
      className={`grid gap-3 ${classes.form}`}
      aria-label={`Log a day, ${title}`}
      draftKey={`day:${id}`}
      initialValues={{ worked_on: today(), quarters: '4', note: '' }}
      mutation={log}
      onSubmit={({ worked_on, quarters, note }, onSuccess) =>
        log.mutate({ worked_on, quarters: Number(quarters), note: note.trim() }, { onSuccess })
      }
    >
      <Field name="worked_on" label="Worked on" description="Logging a day again replaces it." type="date" />
      <Field
        as={NativeSelect}
        name="quarters"
        size="xs"
        label="How much"
        description="In quarters of a day."
        data={CHOICES}
      />
      <Field optional name="note" label="Description" description="Optional." maxLength={2000} />
      <Submit className="row wrap justify-end col-span-full">Log day</Submit>
    </DraftForm>
  )
}
