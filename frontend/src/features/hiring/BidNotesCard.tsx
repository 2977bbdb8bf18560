import { NativeSelect, Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { meQuery } from '@/api/me'
import { DraftForm } from '@/app/drafts/DraftForm'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { shortDay, today } from '@/ui/format'
import { Person } from '@/ui/Person'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'

import { type BidNote, type ComparedBid, type Comparison, useAddNote, useRemoveNote } from './api'
import classes from './Hiring.module.css'

const KINDS = { call: 'Call', interview: 'Interview', other: 'Other' } as const
const emptyNote = (): { kind: keyof typeof KINDS; held_on: string; text: string } => ({
  kind: 'call',
  held_on: today(),
  text: '',
})

/** Notes of calls and interviews with one bidder, for the team only. */
export function BidNotesCard({ comparison, bid }: { comparison: Comparison; bid: ComparedBid }) {
  const add = useAddNote(comparison.posting_id)
  return (
    <Card aria-labelledby="bid-notes">
      <CardHead id="bid-notes" title={`Notes on ${bid.designer.name}`} end="for the team only" />
      {bid.notes.length > 0 && (
        <Rows aria-label="Notes">
          {bid.notes.map((bidNote) => (
            <Row key={bidNote.id}>
              <NoteLine note={bidNote} bidId={bid.id} postingId={comparison.posting_id} />
            </Row>
          ))}
        </Rows>
      )}
      <DraftForm
        className={`grid gap-4 ${classes.form}`}
        aria-label="Add a note"
        draftKey={`bid-note:${bid.id}`}
        initialValues={emptyNote()}
        mutation={add}
        onSubmit={(note, onSuccess) => add.mutate({ id: bid.id, ...note }, { onSuccess })}
      >
        <Field
          as={NativeSelect}
          name="kind"
          label="Occasion"
          data={Object.entries(KINDS).map(([value, label]) => ({ value, label }))}
        />
        <Field name="held_on" label="Day" type="date" />
        <Field as={Textarea} name="text" className={classes.wide} label="Note" maxLength={5000} />
        <Submit variant="plain" className={classes.wide}>
          Add note
        </Submit>
      </DraftForm>
    </Card>
  )
}

function NoteLine({ note, bidId, postingId }: { note: BidNote; bidId: string; postingId: string }) {
  const { data: me } = useQuery(meQuery)
  const remove = useRemoveNote(postingId)
  return (
    <article className="grow" aria-label={`${KINDS[note.kind ?? 'other']} of ${shortDay(note.held_on)}`}>
      <p className="row wrap small mid">
        {`${KINDS[note.kind ?? 'other']}, ${shortDay(note.held_on)}`}
        <Person name={note.author.name} picture={note.author.picture} />
        {me?.person.id === note.author.id && (
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove the note of ${shortDay(note.held_on)}`}
            aria-busy={remove.isPending}
            onClick={() => remove.mutate({ id: bidId, noteId: note.id })}
          />
        )}
      </p>
      <p style={{ whiteSpace: 'pre-wrap' }}>{note.text}</p>
      <Refusal error={remove.error} />
    </article>
  )
}
