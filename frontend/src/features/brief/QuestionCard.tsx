import { Textarea } from '@mantine/core'
import { useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { day } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { StatusBadge } from '@/ui/StatusBadge'

import { type FollowUp, type Question, useAnswerFollowUp, useAskFollowUp } from './api'
import classes from './Brief.module.css'
import { ChoiceField, EffectsField, type FieldProps, NoteField, NumberField, ScenesField, TextField } from './fields'
import { NamesField } from './NamesField'
import type { Answers } from './useAnswers'
import { refused } from './words'

interface QuestionCardProps {
  question: Question
  projectId: string
  answers: Answers
  mayAnswer: boolean
  mayAsk: boolean
  followUps: readonly FollowUp[]
  names: readonly string[]
  categories: readonly string[]
}

/** One question: what it is for, its answer, and what designers asked about it. */
export function QuestionCard({
  question,
  projectId,
  answers,
  mayAnswer,
  mayAsk,
  followUps,
  names,
  categories,
}: QuestionCardProps) {
  const answer = answers.of(question)
  const isUnknown = answer?.is_unknown ?? false
  const isAnswered = answer !== null && !isUnknown && !isEmpty(answer.value)
  const against = answers.against(question.key)
  const field: FieldProps = {
    question,
    value: isUnknown ? null : (answer?.value ?? null),
    onChange: (value) => answers.change(question, { value, is_unknown: false }),
    categories,
  }
  const id = `question-${question.key}`
  return (
    <Card
      className={classes.question}
      id={id}
      tabIndex={-1}
      aria-labelledby={`${id}-text`}
      data-question={question.key}
    >
      <span className={`dim ${classes.number}`}>{question.number}</span>
      <div className="grid gap-3 min-w-0">
        <div className="flex wrap between gap-1-3">
          <h2 id={`${id}-text`}>{question.text}</h2>
          {isAnswered ? (
            <StatusBadge kind="conforming">Answered</StatusBadge>
          ) : isUnknown ? (
            <StatusBadge kind="question">Undecided</StatusBadge>
          ) : (
            <StatusBadge kind="to_make">{question.required ? 'Open, needed' : 'Open'}</StatusBadge>
          )}
        </div>
        <p className="mid">{question.why}</p>
        {mayAnswer ? (
          <>
            <Field {...field} names={names} />
            <p className="small dim">{`For example: ${question.example}`}</p>
            {(isAnswered || isUnknown) && question.kind !== 'text' && (
              <NoteField
                label="Note (optional)"
                value={answer?.note ?? ''}
                onChange={(note) => answers.change(question, { note })}
              />
            )}
            <div className="row wrap">
              <button
                type="button"
                className={`hover rounded pointer narrow-min-h-44px ${classes.choice} narrow-w-full ${classes.unknown}`}
                aria-pressed={isUnknown}
                aria-keyshortcuts="0"
                onClick={() => answers.change(question, { value: null, is_unknown: !isUnknown })}
              >
                I don’t know yet
              </button>
            </div>
          </>
        ) : (
          <p className="pre-line">{question.answer?.words ?? 'No answer yet.'}</p>
        )}
        {against && (
          <ErrorBanner
            detail={refused(against.message)}
            fix={
              against.isConflict && question.answer
                ? `Theirs: ${question.answer.words}`
                : 'What you typed is kept here and is not saved.'
            }
            action={
              against.isConflict && (
                <span className="row">
                  <Button onClick={() => answers.useTheirs(question.key)}>Use theirs</Button>
                  <Button onClick={() => answers.useMine(question.key)}>Save mine</Button>
                </span>
              )
            }
          />
        )}
        {followUps.map((followUp) => (
          <FollowUpLine key={followUp.id} followUp={followUp} projectId={projectId} mayAnswer={mayAnswer} />
        ))}
        {mayAsk && <AskForm projectId={projectId} question={question} />}
      </div>
    </Card>
  )
}

const isEmpty = (value: unknown): boolean =>
  value === null ||
  value === undefined ||
  value === '' ||
  (typeof value === 'object' && Object.keys(value).length === 0)

function Field({ names, ...field }: FieldProps & { names: readonly string[] }) {
  switch (field.question.kind) {
    case 'choice':
    case 'choices':
      return <ChoiceField {...field} />
    case 'text':
    case 'lines':
      return <TextField {...field} />
    case 'number':
      return <NumberField {...field} />
    case 'per_category':
      return <EffectsField {...field} />
    case 'per_scene':
      return <ScenesField {...field} />
    case 'names':
      return <NamesField value={field.value} onChange={field.onChange} names={names} />
  }
}

function FollowUpLine({
  followUp,
  projectId,
  mayAnswer,
}: {
  followUp: FollowUp
  projectId: string
  mayAnswer: boolean
}) {
  const reply = useAnswerFollowUp(projectId)
  const [text, setText, draft] = useDraft(`follow-up:${followUp.id}`, '')
  const send = () =>
    reply.mutate(
      { id: followUp.id, text },
      {
        onSuccess: () => {
          draft.discard()
          showToast('Answer sent.')
        },
      },
    )
  return (
    <div className={`grid gap-2 wrap-anywhere rounded bg-well ${classes.followUp}`}>
      <p>
        <span className="strong">{followUp.asked_by?.name ?? 'Another designer'}</span>{' '}
        <span className="small dim">{day(followUp.asked_at)}</span>
        <br />
        {followUp.text}
      </p>
      {followUp.answer !== null && (
        <p>
          <span className="strong">{followUp.answered_by?.name}</span> {followUp.answer}
        </p>
      )}
      {followUp.answer === null && mayAnswer && (
        <>
          <DraftNote draft={draft} />
          <Textarea
            label="Your answer"
            rows={2}
            resize="vertical"
            maxLength={2000}
            value={text}
            onChange={({ currentTarget }) => setText(currentTarget.value)}
          />
          <div>
            <Button disabled={text.trim() === ''} aria-busy={reply.isPending} onClick={send}>
              Send answer
            </Button>
          </div>
          <Refusal error={reply.error} />
        </>
      )}
    </div>
  )
}

function AskForm({ projectId, question }: { projectId: string; question: Question }) {
  const ask = useAskFollowUp(projectId)
  const [text, setText, draft] = useDraft(`ask:${projectId}:${question.key}`, '')
  const [isOpen, setOpen] = useState(text !== '')
  if (!isOpen) {
    return (
      <div>
        <Button icon="question" onClick={() => setOpen(true)}>
          Ask about this
        </Button>
      </div>
    )
  }
  const send = () =>
    ask.mutate(
      { question: question.key, text },
      {
        onSuccess: () => {
          draft.discard()
          setOpen(false)
          showToast('Question sent to the team.')
        },
      },
    )
  return (
    <>
      <DraftNote draft={draft} />
      <Textarea
        label="Your question"
        rows={2}
        resize="vertical"
        maxLength={2000}
        data-autofocus
        value={text}
        onChange={({ currentTarget }) => setText(currentTarget.value)}
      />
      <div className="row wrap">
        <Button variant="primary" disabled={text.trim() === ''} aria-busy={ask.isPending} onClick={send}>
          Send question
        </Button>
        <Button
          variant="quiet"
          onClick={() => {
            draft.discard()
            setOpen(false)
          }}
        >
          Cancel
        </Button>
      </div>
      <Refusal error={ask.error} />
    </>
  )
}
