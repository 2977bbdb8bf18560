import { Textarea } from '@mantine/core'

import { useDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'

import { type Posting, useAnswer } from './api'
import classes from './Hiring.module.css'

/** What designers ask about a posting, each with its answer or the field for one. */
export function QuestionsCard({ posting }: { posting: Posting }) {
  return (
    <Card aria-labelledby="questions">
      <CardHead id="questions" title="Questions" count={posting.questions.length} />
      {posting.questions.length === 0 && (
        <EmptyState head="No question yet" level={3}>
          What designers ask appears here, and you get an email.
        </EmptyState>
      )}
      {posting.questions.map(({ id, text, asked_by: by, answer, is_for_all: forAll }) => (
        <div key={id} className={`grid gap-3 ${classes.body}`}>
          <p>
            <span className="strong">{by?.name}</span> {text}
          </p>
          {answer === null ? (
            <AnswerForm postingId={posting.id} id={id} />
          ) : (
            <p className="mid">{`${answer} (${forAll ? 'for all' : 'for who asked'})`}</p>
          )}
        </div>
      ))}
    </Card>
  )
}

function AnswerForm({ postingId, id }: { postingId: string; id: string }) {
  const [text, setText, draft] = useDraft(`posting-answer:${id}`, '')
  const answer = useAnswer(postingId)
  const send = (forAll: boolean) => {
    if (answer.isPending || text.trim() === '') return
    answer.mutate({ id, text, forAll }, { onSuccess: () => draft.discard() })
  }
  return (
    <>
      <Textarea
        label="Answer"
        value={text}
        maxLength={2000}
        onChange={({ currentTarget }) => setText(currentTarget.value)}
      />
      <Refusal error={answer.error} />
      <div className="row wrap">
        <Button disabled={text.trim() === ''} onClick={() => send(true)}>
          Answer for all
        </Button>
        <Button variant="quiet" disabled={text.trim() === ''} onClick={() => send(false)}>
          Answer this one only
        </Button>
      </div>
    </>
  )
}
