import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { type Cue } from '../api'
import { type FactQuestion, useAnswerFact, useDismissFact } from '../clarity'
import classes from '../cue/Panel.module.css'

const GROUP = 'Unclear cue'

interface ClarifyPanelProps {
  cue: Cue
  projectId: string
  questions: readonly FactQuestion[]
  onClose: () => void
}

/** What a designer could not know from the words of a cue: an answer each, or none. */
export function ClarifyPanel({ cue, projectId, questions, onClose }: ClarifyPanelProps) {
  const answer = useAnswerFact(projectId, cue.id)
  const dismiss = useDismissFact(projectId, cue.id)
  const busy = answer.isPending || dismiss.isPending
  const first = questions[0]
  const say = (question: FactQuestion, text: string) => {
    if (busy || text.trim() === '') return
    answer.mutate({ fact: question.fact, text }, { onSuccess: () => (questions.length === 1 ? onClose() : undefined) })
  }
  const drop = (question: FactQuestion) => {
    if (busy) return
    dismiss.mutate(
      { fact: question.fact, dismissed: true },
      {
        onSuccess: () => {
          showToast(`“${question.question}” is not asked of ${cue.name} any more.`, () =>
            dismiss.mutate({ fact: question.fact, dismissed: false }),
          )
          if (questions.length === 1) onClose()
        },
      },
    )
  }
  useHotkeys([
    ...(first?.answers ?? []).map((text, at) => ({
      keys: String(at + 1),
      label: 'Choose an answer',
      group: GROUP,
      unlisted: at > 0,
      run: () => first && say(first, text),
    })),
    { keys: 'd', label: 'Dismiss the question', group: GROUP, run: () => first && drop(first), disabled: !first },
  ])
  return (
    <section className={`grid gap-3 narrow-p-3 ${classes.panel}`} aria-label={`What is unclear about ${cue.name}`}>
      {first === undefined && <p>Every question is answered.</p>}
      {questions.map((question) => (
        <Asked
          key={question.fact}
          question={question}
          isFirst={question === first}
          busy={busy}
          onSay={say}
          onDrop={drop}
        />
      ))}
      <Refusal error={answer.error ?? dismiss.error} />
      <div className="row wrap">
        <span className="small dim">
          Each answer is added to the description, or becomes the category. Unclear cues can be delivered all the same.
        </span>
        <Button className="end" keys="Escape" onClick={onClose}>
          Close
        </Button>
      </div>
    </section>
  )
}

interface AskedProps {
  question: FactQuestion
  /** Its answers have the keys. */
  isFirst: boolean
  busy: boolean
  onSay: (question: FactQuestion, text: string) => void
  onDrop: (question: FactQuestion) => void
}

function Asked({ question, isFirst, busy, onSay, onDrop }: AskedProps) {
  const [text, setText] = useState('')
  return (
    <form
      className={`grid gap-1 ${classes.question}`}
      aria-label={question.question}
      onSubmit={(event) => {
        event.preventDefault()
        onSay(question, text)
      }}
    >
      <span className="strong">{question.question}</span>
      <span className="row wrap">
        {question.answers.map((answer, at) => (
          <Button
            key={answer}
            keys={isFirst ? String(at + 1) : undefined}
            disabled={busy}
            onClick={() => onSay(question, answer)}
          >
            {answer}
          </Button>
        ))}
        <TextInput
          aria-label={`${question.question} In other words`}
          placeholder="In other words"
          value={text}
          maxLength={200}
          onChange={(event) => setText(event.currentTarget.value)}
        />
        {text.trim() !== '' && (
          <Button type="submit" variant="primary" disabled={busy}>
            Add
          </Button>
        )}
        <Button variant="quiet" keys={isFirst ? 'd' : undefined} disabled={busy} onClick={() => onDrop(question)}>
          Not needed
        </Button>
      </span>
    </form>
  )
}
