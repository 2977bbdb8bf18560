import { NativeSelect, TextInput } from '@mantine/core'
import { keptCuesQuery } from '@/api/soundList'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent, useState } from 'react'

import { useDraft } from '@/app/drafts'
import { type ContractMoney, useLogHours, type WorkedDay } from '@/money/api'
import { hours, minutesOf } from '@/money/words'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { day, today } from '@/ui/format'

import classes from './Page.module.css'

interface HoursFormProps {
  contract: ContractMoney
  projectId: string
  /** The entry that is corrected and sent again; without one, hours are logged. */
  corrected: WorkedDay | undefined
  onDone: () => void
}

const NO_CUE = { value: '', label: 'No cue' }

/** Logs hours, or corrects some that were refused or wait: which day, how long, and for which cue or work. */
export function HoursForm({ contract, projectId, corrected, onDone }: HoursFormProps) {
  const key = `hours:${corrected?.id ?? contract.contract_id}`
  const log = useLogHours(contract.contract_id, corrected?.id)
  const { data: cues = [] } = useQuery(keptCuesQuery(projectId))
  const [typed, setTyped, draft] = useDraft(key, {
    on: corrected?.worked_on ?? today(),
    cue: corrected?.cue?.id ?? '',
    length: corrected ? hours(corrected.minutes ?? 0) : '',
    note: corrected?.note ?? '',
  })
  const { on, cue, length, note } = typed
  const change = (changes: Partial<typeof typed>) => setTyped({ ...typed, ...changes })
  const [wasSent, setWasSent] = useState(false)
  const minutes = minutesOf(length)
  const faults = {
    on: on === '' ? 'Enter a date.' : undefined,
    length: minutes === null ? 'Enter hours as in 1.5, 1:30 or 1 h 30 min, at most 24.' : undefined,
    note: cue === '' && note.trim() === '' ? 'Choose a cue, or say what the hours were for.' : undefined,
  }
  const send = (event: FormEvent) => {
    event.preventDefault()
    setWasSent(true)
    if (faults.on || minutes === null || faults.note || log.isPending) return
    log.mutate(
      { worked_on: on, minutes, cue_id: cue || null, note: note.trim() },
      {
        onSuccess: () => {
          draft.discard()
          setWasSent(false)
          onDone()
        },
      },
    )
  }
  const name = corrected ? `Correct hours on ${day(corrected.worked_on)}` : `Log hours, ${contract.title}`
  return (
    <form className={`grid gap-3 ${classes.form}`} onSubmit={send} noValidate aria-label={name}>
      {corrected && (
        <p className={`strong ${classes.wide}`} role="status">
          {name}
        </p>
      )}
      <TextInput
        label="Worked on"
        type="date"
        value={on}
        onChange={({ currentTarget }) => change({ on: currentTarget.value })}
        error={wasSent && faults.on}
      />
      <TextInput
        label="Hours"
        description="1.5, 1:30 or 1 h 30 min."
        value={length}
        maxLength={20}
        onChange={({ currentTarget }) => change({ length: currentTarget.value })}
        error={wasSent && faults.length}
      />
      <NativeSelect
        size="xs"
        label="Cue"
        description="Or describe the work."
        data={[NO_CUE, ...cues.map(({ id, label, name: called }) => ({ value: id, label: `${label} ${called}` }))]}
        value={cue}
        onChange={({ currentTarget }) => change({ cue: currentTarget.value })}
      />
      <TextInput
        label="Work"
        description="What it was."
        value={note}
        maxLength={2000}
        onChange={({ currentTarget }) => change({ note: currentTarget.value })}
        error={wasSent && faults.note}
      />
      <Refusal error={log.error} className={classes.wide} />
      <div className="row wrap justify-end col-span-full">
        {corrected && (
          <Button variant="quiet" onClick={onDone}>
            Cancel
          </Button>
        )}
        <Button type="submit" variant="primary" aria-busy={log.isPending}>
          {corrected ? 'Send again' : 'Log hours'}
        </Button>
      </div>
    </form>
  )
}
