import { Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { type FormEvent } from 'react'

import { meQuery } from '@/api/me'
import { DraftNote, useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { shortDay, today } from '@/ui/format'
import { Person } from '@/ui/Person'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'
import { Select } from '@/ui/Select'

import { type BidNote, type ComparedBid, type Comparison, useAddNote, useRemoveNote } from './api'
import classes from './Hiring.module.css'

const KINDS = { call: 'Call', interview: 'Interview', other: 'Other' } as const
type Kind = keyof typeof KINDS
const emptyNote = () => ({ kind: 'call' as Kind, held_on: today(), text: '' })

/** Notes of calls and interviews with one bidder, for the team only. */
export function BidNotesCard({ comparison, bid }: { comparison: Comparison; bid: ComparedBid }) {
  const [note, set, draft] = useDraft(`bid-note:${bid.id}`, emptyNote)
  const add = useAddNote(comparison.posting_id)
  const send = (event: FormEvent) => {
    event.preventDefault()
    if (add.isPending || !note.text.trim()) return
    add.mutate({ id: bid.id, ...note }, { onSuccess: () => draft.discard() })
  }
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
      <form className={`grid gap-4 ${classes.form}`} onSubmit={send} noValidate aria-label="Add a note">
        <div className={classes.wide}>
          <DraftNote draft={draft} />
        </div>
        <Select
          label="Occasion"
          value={note.kind}
          onChange={({ currentTarget: { value } }) => set((before) => ({ ...before, kind: value as Kind }))}
        >
          {Object.entries(KINDS).map(([kind, label]) => (
            <option key={kind} value={kind}>
              {label}
            </option>
          ))}
        </Select>
        <TextInput
          label="Day"
          type="date"
          value={note.held_on}
          onChange={({ currentTarget: { value } }) => set((before) => ({ ...before, held_on: value }))}
        />
        <Textarea
          className={classes.wide}
          label="Note"
          maxLength={5000}
          value={note.text}
          onChange={({ currentTarget: { value } }) => set((before) => ({ ...before, text: value }))}
        />
        <div className={classes.wide}>
          <Refusal error={add.error} />
          <Button type="submit" aria-busy={add.isPending} disabled={!note.text.trim()}>
            Add note
          </Button>
        </div>
      </form>
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
