import { type KeyboardEvent, type ReactNode, useId, useLayoutEffect, useRef, useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import type { TimeRange } from '@/audio'
import { WordList } from '@/references'
import { Button } from '@/ui/Button'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { place, range as rangeWords } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'

import classes from './ChangeForm.module.css'
import { Mentions } from './Mentions'
import { SendField } from './SendField'
import type { ChangeNote } from './useVerdicts'

type Where = 'whole' | 'point' | 'range'

interface ChangeFormProps {
  /** The version that it is about. */
  takeId: string
  /** Whose word list is offered. */
  projectId?: string
  /** What is to change: "shield_hit A". */
  what: string
  /** The studio's list, in the order of the digits. */
  listed: readonly string[]
  /** Where the playhead stands; 0 is not a place. */
  positionS: number
  range: TimeRange | null
  saving: boolean
  error: unknown
  /** What it takes back, where the version is approved. */
  reversal?: ReactNode
  /** Who gets it. */
  to?: string
  /** What it counts: "Round 1 of 2 begins with it." */
  counts?: string
  /** `done` ends the form's draft, once the change is requested. */
  onSave: (change: ChangeNote, done: () => void) => void
  onClose: () => void
}

/** What to change: reasons on the digits, a text, where in the sound. Enter sends it; for ten seconds it can be undone. */
export function ChangeForm({
  takeId,
  projectId,
  what,
  listed,
  positionS,
  range,
  saving,
  error,
  reversal,
  to = 'the designer',
  counts = '',
  onSave,
  onClose,
}: ChangeFormProps) {
  const [{ reasons, text }, setSaid, draft] = useDraft<{ reasons: readonly string[]; text: string }>(
    `change:${takeId}`,
    { reasons: [], text: '' },
  )
  const setText = (next: string) => setSaid((now) => ({ ...now, text: next }))
  const [where, setWhere] = useState<Where>(range ? 'range' : positionS > 0 ? 'point' : 'whole')
  const [empty, setEmpty] = useState(false)
  const field = useRef<HTMLTextAreaElement>(null)
  const errorId = useId()

  // Before the next key: continued typing must not decide anything.
  useLayoutEffect(() => field.current?.focus(), [])
  useHotkeys([{ keys: 'Escape', label: 'Close without requesting a change', group: 'Review', run: onClose }])

  const toggle = (reason: string) => {
    setEmpty(false)
    setSaid((now) => ({
      ...now,
      reasons: now.reasons.includes(reason)
        ? now.reasons.filter((other) => other !== reason)
        : [...now.reasons, reason],
    }))
  }
  const save = () => {
    const note = [...reasons.map((reason) => `${reason}.`), text.trim()].filter(Boolean).join(' ')
    if (note === '') {
      setEmpty(true)
      field.current?.focus()
      return
    }
    if (where === 'range' && range) onSave({ note, reasons, startS: range.startS, endS: range.endS }, draft.discard)
    else onSave({ note, reasons, startS: where === 'point' ? positionS : undefined }, draft.discard)
  }
  const onKeyDown = (event: KeyboardEvent) => {
    const reason = /^[1-9]$/.test(event.key) ? listed[Number(event.key) - 1] : undefined
    if (reason !== undefined && text === '' && reasons.length === 0) {
      // The first digit is a reason; after it one types, and "3 dB less" begins with a digit too.
      event.preventDefault()
      toggle(reason)
    }
  }

  // One that was chosen and is off the list since can still be taken back.
  const offered = [...listed, ...reasons.filter((reason) => !listed.includes(reason))]

  const places: { value: Where; label: string }[] = [
    { value: 'whole', label: 'Whole sound' },
    ...(positionS > 0 ? [{ value: 'point' as const, label: `At ${place(positionS)}` }] : []),
    ...(range ? [{ value: 'range' as const, label: rangeWords(range.startS, range.endS) }] : []),
  ]

  return (
    <form
      className="grid gap-2"
      aria-label={`What to change in ${what}`}
      onSubmit={(event) => {
        event.preventDefault()
        save()
      }}
    >
      <div className={`flex wrap gap-6px ${classes.reasons}`} role="group" aria-label="Reasons">
        <span className="strong">Request a change of {what}</span>
        {offered.map((reason, index) => (
          <Button
            key={reason}
            keys={index < listed.length ? String(index + 1) : undefined}
            pressed={reasons.includes(reason)}
            onClick={() => {
              toggle(reason)
              field.current?.focus()
            }}
          >
            {reason}
          </Button>
        ))}
      </div>
      <SendField
        ref={field}
        className={`line-field ${classes.text}`}
        aria-label={`What to change in ${what}`}
        aria-invalid={empty || undefined}
        aria-describedby={empty ? errorId : undefined}
        placeholder={`What to change (${to} reads this)`}
        value={text}
        onText={(next) => {
          setText(next)
          setEmpty(false)
        }}
        onKeyDown={onKeyDown}
        onSend={() => {
          if (!saving) save()
        }}
        onLeave={onClose}
      />
      <Mentions takeId={takeId} field={field} text={text} onText={setText} />
      {projectId !== undefined && <WordList projectId={projectId} text={text} />}
      {empty && <FieldError id={errorId}>Choose a reason or write what to change.</FieldError>}
      <Refusal error={error} />
      {reversal}
      <DraftNote draft={draft} />
      <div className="row wrap">
        <p className="small mid grow">{counts} You can undo it for 10 seconds.</p>
        {places.length > 1 && <Segmented label="Where" options={places} value={where} onChange={setWhere} />}
        <Button variant="quiet" onClick={onClose} keys="Escape">
          Cancel
        </Button>
        <Button variant="primary" type="submit" keys="Enter" disabled={saving}>
          Send to {to}
        </Button>
      </div>
    </form>
  )
}
