import { useState } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { useRefuseDay, useSettleDay, type WorkedDay } from '@/money/api'
import { amount } from '@/money/words'
import { Button } from '@/ui/Button'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { Row } from '@/ui/Rows'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import classes from './Page.module.css'

const STATES = { agreed: 'agreed', waiting: 'waiting for the studio', refused: 'refused' }

interface WorkRowProps {
  work: WorkedDay
  /** How much of the day: "half day", "1 h 30 min". */
  length: string
  currency: string
  side: 'team' | 'designer'
  isProducer: boolean
  /** Opens a form in which the designer corrects it; without one, logging the day again does. */
  onCorrect?: () => void
}

/** One logged day or some hours of it: the studio agrees or refuses, the designer corrects or removes. */
export function WorkRow({ work, length, currency, side, isProducer, onCorrect }: WorkRowProps) {
  const settle = useSettleDay(work.id)
  const [isRefusing, setIsRefusing] = useState(false)
  const named = day(work.worked_on)
  const sum = amount(work.amount_minor, currency)
  const details = [length, work.cue?.name, work.note].filter(Boolean).join(', ')
  const isWaiting = work.state === 'waiting'
  return (
    <Row className={classes.work}>
      <span className="grow">
        <span className={work.state === 'agreed' ? undefined : 'strong'}>{named}</span>
        <span className="small mid">
          {' '}
          {details}, {STATES[work.state]}
        </span>
        {work.state === 'refused' && (
          <span className="small block wrap-anywhere">
            The studio refused it: {work.refusal}
            {side === 'designer' && (onCorrect ? ' Correct it to send it again.' : ' Log the day again to correct it.')}
          </span>
        )}
      </span>
      {work.state !== 'refused' && (
        <span className="nowrap">{work.amount_minor === 0 ? <span className="small mid">included</span> : sum}</span>
      )}
      {isWaiting && side === 'team' && isProducer && (
        <>
          <Button
            aria-busy={settle.isPending}
            onClick={() => settle.mutate('agree')}
            aria-label={`Agree to ${length} on ${named}, ${sum}`}
          >
            Agree
          </Button>
          <Button
            variant="quiet"
            aria-expanded={isRefusing}
            onClick={() => setIsRefusing(!isRefusing)}
            aria-label={`Refuse ${length} on ${named}`}
          >
            Refuse…
          </Button>
        </>
      )}
      {work.state !== 'agreed' && side === 'designer' && (
        <>
          {onCorrect && (
            <Button onClick={onCorrect} aria-label={`Correct ${length} on ${named}`}>
              Correct
            </Button>
          )}
          <Button
            variant="quiet"
            onClick={() => settle.mutate('take back')}
            aria-label={`Remove ${length} on ${named}`}
          >
            Remove
          </Button>
        </>
      )}
      <Refusal error={settle.error} className={classes.problem} />
      {isRefusing && isWaiting && (
        <RefuseForm work={work} name={`Refuse ${length} on ${named}`} onDone={() => setIsRefusing(false)} />
      )}
    </Row>
  )
}

function RefuseForm({ work, name, onDone }: { work: WorkedDay; name: string; onDone: () => void }) {
  const refuse = useRefuseDay(work.id)
  const field = useFocusOnMount<HTMLInputElement>()
  return (
    <DraftForm
      className={`grid gap-3 ${classes.form} ${classes.inRow}`}
      aria-label={name}
      draftKey={`refusal:${work.id}`}
      initialValues={{ reason: '' }}
      mutation={refuse}
      checks={({ reason }) => ({ reason: reason.trim() === '' && 'Say why.' })}
      onSubmit={({ reason }, onSent) =>
        refuse.mutate(
          { reason: reason.trim() },
          {
            onSuccess: () => {
              onSent()
              onDone()
            },
          },
        )
      }
    >
      <Field
        ref={field}
        name="reason"
        className={classes.wide}
        label="Why"
        description="The designer reads it, and can correct the entry and send it again."
        maxLength={2000}
      />
      <Submit variant="plain" className="row wrap justify-end col-span-full" onCancel={onDone}>
        Refuse
      </Submit>
    </DraftForm>
  )
}
