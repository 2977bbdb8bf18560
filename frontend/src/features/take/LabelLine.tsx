import { useId } from 'react'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { Field, Submit } from '@/ui/Form'
import { useSetLabel } from '@/verdicts/labels'
import { useReasons } from '@/verdicts/reasons'

import type { Take } from './api'

/** What the version is among alternates, of the studio's list or in other words. */
export function LabelLine({ take }: { take: Take }) {
  const saved = take.label ?? ''
  const { label: listed } = useReasons(take.project_id)
  const label = useSetLabel()
  const listId = useId()
  return (
    <DraftForm
      className="row wrap items-end mt-2"
      aria-label="Label"
      draftKey={`label:${take.id}:${saved}`}
      initialValues={{ text: saved }}
      mutation={label}
      onSubmit={({ text }, onSent) => {
        const words = text.trim()
        label.mutate(
          { takeId: take.id, label: words || null },
          {
            onSuccess: () => {
              onSent()
              showToast(words ? `Labelled “${words}”.` : 'The label is gone.')
            },
          },
        )
      }}
    >
      {({ text }) => (
        <>
          <Field optional name="text" label="Label" list={listId} maxLength={40} placeholder="longer, layered, wild" />
          <datalist id={listId}>
            {listed.map((option) => (
              <option key={option} value={option} />
            ))}
          </datalist>
          <Submit variant="plain" disabled={text.trim() === saved}>
            {text.trim() === '' && saved !== '' ? 'Take away' : 'Save label'}
          </Submit>
        </>
      )}
    </DraftForm>
  )
}
