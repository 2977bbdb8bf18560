import { Textarea } from '@mantine/core'

import { DraftNote, useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

import { type ComparedBid, type Comparison, useScore } from './api'
import classes from './Hiring.module.css'

/** Marks of one person for a bid, and those of the others once given. */
export function ScoreCard({ comparison, bid }: { comparison: Comparison; bid: ComparedBid }) {
  const { headings, posting_id: postingId } = comparison
  const [now, set, draft] = useDraft(`scores:${bid.id}`, {
    scores: bid.own_scores?.scores ?? {},
    note: bid.own_scores?.note ?? '',
  })
  const score = useScore(postingId)
  const left = headings.filter((heading) => now.scores[heading] === undefined)
  const send = () => score.mutate({ id: bid.id, ...now }, { onSuccess: () => draft.discard() })
  return (
    <Card aria-labelledby="scores">
      <CardHead
        id="scores"
        title={`Your scores for ${bid.designer.name}`}
        note={left.length > 0 ? `${left.length} to give` : undefined}
      />
      <div className={`grid gap-4 ${classes.form}`}>
        <div className={classes.wide}>
          <DraftNote draft={draft} />
        </div>
        {headings.map((heading) => (
          <Select
            key={heading}
            label={heading}
            value={now.scores[heading] ?? ''}
            onChange={({ currentTarget: { value } }) =>
              set((before) => ({ ...before, scores: { ...before.scores, [heading]: Number(value) } }))
            }
          >
            <option value="" disabled>
              1 to 5
            </option>
            {[1, 2, 3, 4, 5].map((value) => (
              <option key={value} value={value}>
                {value}
              </option>
            ))}
          </Select>
        ))}
        <Textarea
          className={classes.wide}
          label="Note"
          maxLength={5000}
          value={now.note}
          onChange={({ currentTarget: { value: note } }) => set((before) => ({ ...before, note }))}
        />
        <div className={classes.wide}>
          <Refusal error={score.error} />
          <Button aria-busy={score.isPending} onClick={send}>
            Save scores
          </Button>
        </div>
        {bid.others
          ?.filter(({ note }) => note !== '')
          .map(({ person, note }) => (
            <p key={person.id} className={classes.wide}>
              <span className="strong">{person.name}</span> {note}
            </p>
          ))}
      </div>
    </Card>
  )
}
