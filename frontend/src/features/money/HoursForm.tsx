import { NativeSelect } from '@mantine/core'
import { keptCuesQuery } from '@/api/soundList'
import { DraftForm } from '@/app/drafts/DraftForm'
import { useQuery } from '@tanstack/react-query'

import { type ContractMoney, useLogHours, type WorkedDay } from '@/money/api'
import { hours, minutesOf } from '@/money/words'
import { Field, Submit } from '@/ui/Form'
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
  const log = useLogHours(contract.contract_id, corrected?.id)
  const { data: cues = [] } = useQuery(keptCuesQuery(projectId))
  const name = corrected ? `Correct hours on ${day(corrected.worked_on)}` : `Log hours, ${contract.title}`
  return (
    <DraftForm
      className={`grid gap-3 ${classes.form}`}
      aria-label={name}
      draftKey={`hours:${corrected?.id ?? contract.contract_id}`}
      initialValues={{
        on: corrected?.worked_on ?? today(),
        cue: corrected?.cue?.id ?? '',
        length: corrected ? hours(corrected.minutes ?? 0) : '',
        note: corrected?.note ?? '',
      }}
      mutation={log}
      checks={({ cue, length, note }) => ({
        length: minutesOf(length) === null && 'Enter hours as in 1.5, 1:30 or 1 h 30 min, at most 24.',
        note: cue === '' && note.trim() === '' && 'Choose a cue, or say what the hours were for.',
      })}
      onSubmit={({ on, cue, length, note }, onSent) =>
        log.mutate(
          { worked_on: on, minutes: minutesOf(length), cue_id: cue || null, note: note.trim() },
          {
            onSuccess: () => {
              onSent()
              onDone()
            },
          },
        )
      }
    >
      {corrected && (
        <p className={`strong ${classes.wide}`} role="status">
          {name}
        </p>
      )}
      <Field name="on" label="Worked on" type="date" />
      <Field name="length" label="Hours" description="1.5, 1:30 or 1 h 30 min." maxLength={20} />
      <Field
        as={NativeSelect}
        optional
        name="cue"
        size="xs"
        label="Cue"
        description="Or describe the work."
        data={[NO_CUE, ...cues.map(({ id, label, name: called }) => ({ value: id, label: `${label} ${called}` }))]}
      />
      <Field optional name="note" label="Work" description="What it was." maxLength={2000} />
      <Submit className="row wrap justify-end col-span-full" onCancel={corrected && onDone}>
        {corrected ? 'Send again' : 'Log hours'}
      </Submit>
    </DraftForm>
  )
}
