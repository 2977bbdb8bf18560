import { NativeSelect, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { useDraft } from '@/app/drafts'
import { daysQuery, type ContractMoney, useLogDay } from '@/money/api'
import { amount, money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { today } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
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

function LogForm({ contract }: { contract: ContractMoney }) {
  const log = useLogDay(contract.contract_id)
  const [on, setOn] = useState(today())
  const [quarters, setQuarters] = useState('4')
  const [note, setNote, draft] = useDraft(`day:${contract.contract_id}`, '')
  const [lacksDay, setLacksDay] = useState(false)
  const send = (event: FormEvent) => {
    event.preventDefault()
    setLacksDay(on === '')
    if (on === '' || log.isPending) return
    log.mutate({ worked_on: on, quarters: Number(quarters), note: note.trim() }, { onSuccess: draft.discard })
  }
  return (
    <form
      className={`grid gap-3 ${classes.form}`}
      onSubmit={send}
      noValidate
      aria-label={`Log a day, ${contract.title}`}
    >
      <TextInput
        label="Worked on"
        description="Logging a day again replaces it."
        type="date"
        value={on}
        onChange={({ currentTarget }) => setOn(currentTarget.value)}
        error={lacksDay ? 'Enter a date.' : undefined}
      />
      <NativeSelect
        size="xs"
        label="How much"
        description="In quarters of a day."
        data={CHOICES}
        value={quarters}
        onChange={({ currentTarget }) => setQuarters(currentTarget.value)}
      />
      <TextInput
        label="Description"
        description="Optional."
        value={note}
        maxLength={2000}
        onChange={({ currentTarget }) => setNote(currentTarget.value)}
      />
      <Refusal error={log.error} className={classes.wide} />
      <div className="row wrap justify-end col-span-full">
        <Button type="submit" variant="primary" aria-busy={log.isPending}>
          Log day
        </Button>
      </div>
    </form>
  )
}
