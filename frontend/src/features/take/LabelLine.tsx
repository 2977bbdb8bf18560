import { type FormEvent, useId } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { useSetLabel } from '@/verdicts/labels'
import { useReasons } from '@/verdicts/reasons'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import type { Take } from './api'
import classes from './Take.module.css'

/** What the version is among alternates, of the studio's list or in other words. */
export function LabelLine({ take }: { take: Take }) {
  const saved = take.label ?? ''
  const [text, setText, draft] = useDraft(`label:${take.id}:${saved}`, saved)
  const { label: listed } = useReasons(take.project_id)
  const label = useSetLabel()
  const listId = useId()
  const onSubmit = (event: FormEvent) => {
    event.preventDefault()
    const words = text.trim()
    if (label.isPending || words === saved) return
    label.mutate(
      { takeId: take.id, label: words || null },
      {
        onSuccess: () => {
          draft.discard()
          showToast(words ? `Labelled “${words}”.` : 'The label is gone.')
        },
      },
    )
  }
  return (
    <form className="row wrap mt-2" onSubmit={onSubmit} aria-label="Label">
      <label className="small strong" htmlFor={`${listId}-field`}>
        Label
      </label>
      <input
        id={`${listId}-field`}
        className={`line-field ${classes.labelField}`}
        list={listId}
        maxLength={40}
        placeholder="longer, layered, wild"
        value={text}
        onChange={(event) => setText(event.currentTarget.value)}
      />
      <datalist id={listId}>
        {listed.map((option) => (
          <option key={option} value={option} />
        ))}
      </datalist>
      <Button type="submit" disabled={text.trim() === saved} aria-busy={label.isPending}>
        {text.trim() === '' && saved !== '' ? 'Take away' : 'Save label'}
      </Button>
      <DraftNote draft={draft} />
      <Refusal error={label.error} />
    </form>
  )
}
