import { Checkbox, NativeSelect, Textarea, TextInput } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useEffect, useRef, useState } from 'react'

import { projectQuery } from '@/api/project'
import { useRoles } from '@/api/roles'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { ago, dueDay } from '@/ui/format'
import { Person } from '@/ui/Person'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Cue, type Question, useAnswer, useAsk, useQuestionChange } from '../api'
import fields from './CueFields.module.css'
import classes from './Panel.module.css'

/** One question on a cue with its answer, or with the field for it. */
export function QuestionLine({
  question,
  projectId,
  mayAnswer,
  opens = false,
}: {
  question: Question
  projectId: string
  mayAnswer: boolean
  /** Its field takes the focus as it opens. */
  opens?: boolean
}) {
  const roleOf = useRoles(projectId)
  return (
    <article className={`grid gap-1 ${classes.question}`} aria-label={`Question: ${question.text}`}>
      <p className="small dim">
        {question.answer === null && (
          <>
            <StatusBadge kind="question" />{' '}
          </>
        )}
        {question.asked_by ? (
          <Person
            name={question.asked_by.name}
            picture={question.asked_by.picture}
            role={roleOf(question.asked_by.id)}
          />
        ) : (
          'Another designer'
        )}{' '}
        asked {ago(question.asked_at)}
      </p>
      <p className={question.answer === null ? 'strong' : ''}>{question.text}</p>
      {question.answer === null && <Urgency question={question} />}
      {question.answer === null && mayAnswer && <UrgencyFields question={question} projectId={projectId} />}
      {question.answer !== null && (
        <>
          <p className="small dim">
            {question.answered_by && (
              <Person
                name={question.answered_by.name}
                picture={question.answered_by.picture}
                role={roleOf(question.answered_by.id)}
              />
            )}{' '}
            answered {question.answered_at && ago(question.answered_at)}
          </p>
          <p className={`pre-line wrap-anywhere ${classes.quote}`}>{question.answer}</p>
        </>
      )}
      {question.answer === null && mayAnswer && <AnswerForm question={question} projectId={projectId} opens={opens} />}
      {question.answer === null && !mayAnswer && <p className="small dim">Waiting for the team’s answer.</p>}
    </article>
  )
}

/** Who answers, by when, and what waits for it. */
function Urgency({ question: { owner, due_on, blocks } }: { question: Question }) {
  const facts = [owner && `${owner.name} answers`, due_on && `due ${dueDay(due_on)}`, blocks && 'work waits for it']
  const words = facts.filter(Boolean).join(', ')
  return words === '' ? null : <p className="small mid">{words.charAt(0).toUpperCase() + words.slice(1)}.</p>
}

function UrgencyFields({ question, projectId }: { question: Question; projectId: string }) {
  const { data: project } = useQuery(projectQuery(projectId))
  const change = useQuestionChange(projectId, question.id)
  const leads = project ? [project.approver, ...project.liaisons] : []
  const people = new Map([...leads, ...(question.owner ? [question.owner] : [])].map(({ id, name }) => [id, name]))
  return (
    <details>
      <summary className="small">Owner and due date</summary>
      <div className={`grid items-end gap-2 grid-cols-1-auto narrow-grid-cols-1 ${classes.say}`}>
        <NativeSelect
          label="Owner"
          value={question.owner?.id ?? ''}
          data={[
            { value: '', label: 'Anyone on the team' },
            ...[...people].map(([value, label]) => ({ value, label })),
          ]}
          onChange={(event) => change.mutate({ owner_id: event.currentTarget.value || null })}
        />
        <TextInput
          type="date"
          label="Due"
          value={question.due_on ?? ''}
          onChange={(event) => change.mutate({ due_on: event.currentTarget.value || null })}
        />
      </div>
      <BlocksField checked={question.blocks} onChange={(blocks) => change.mutate({ blocks })} />
      <Refusal error={change.error} />
    </details>
  )
}

function BlocksField({ checked, onChange }: { checked: boolean; onChange: (checked: boolean) => void }) {
  return (
    <Checkbox
      mt="xs"
      label="Work on this sound waits for the answer"
      checked={checked}
      onChange={(event) => onChange(event.currentTarget.checked)}
    />
  )
}

function AnswerForm({ question, projectId, opens }: { question: Question; projectId: string; opens: boolean }) {
  const [text, setText, draft] = useDraft(`answer:${question.id}`, '')
  const [joins, setJoins] = useState(true)
  const answer = useAnswer(projectId)
  const field = useRef<HTMLTextAreaElement>(null)
  useEffect(() => {
    if (opens) field.current?.focus()
  }, [opens])
  const send = () => {
    const trimmed = text.trim()
    if (trimmed === '' || answer.isPending) return
    answer.mutate(
      { questionId: question.id, text: trimmed, joins },
      {
        onSuccess: () => {
          draft.discard()
          showToast(`Answered.${joins ? ` It was added to the description of ${question.cue_name}.` : ''}`)
        },
      },
    )
  }
  return (
    <form
      className={classes.said}
      onSubmit={(event) => {
        event.preventDefault()
        send()
      }}
    >
      <div className={`grid items-end gap-2 grid-cols-1-auto narrow-grid-cols-1 ${classes.say}`}>
        <Textarea
          ref={field}
          label="Your answer"
          rows={1}
          classNames={{ input: fields.grows }}
          value={text}
          onChange={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) send()
          }}
        />
        <Button type="submit" variant="primary" disabled={answer.isPending || text.trim() === ''}>
          Answer
        </Button>
      </div>
      <Checkbox
        mt="xs"
        label="Add it to the cue’s description"
        checked={joins}
        onChange={(event) => setJoins(event.currentTarget.checked)}
      />
      <DraftNote draft={draft} />
      <Refusal error={answer.error} />
    </form>
  )
}

interface AskFormProps {
  cue: Cue
  projectId: string
  /** Take the focus as it opens. */
  opens?: boolean
  onAsked?: () => void
}

/** Ask the team what it means by a cue. */
export function AskForm({ cue, projectId, opens = false, onAsked }: AskFormProps) {
  const [text, setText, draft] = useDraft(`ask:${cue.id}`, '')
  const [blocks, setBlocks] = useState(false)
  const ask = useAsk(projectId, cue.id)
  const field = useRef<HTMLTextAreaElement>(null)
  useEffect(() => {
    if (opens) field.current?.focus()
  }, [opens])
  const send = () => {
    const trimmed = text.trim()
    if (trimmed === '' || ask.isPending) return
    ask.mutate(
      { text: trimmed, blocks },
      {
        onSuccess: () => {
          draft.discard()
          setBlocks(false)
          showToast(`Question about ${cue.name} sent. The team sees it on Today.`)
          onAsked?.()
        },
      },
    )
  }
  return (
    <form
      className={classes.said}
      onSubmit={(event) => {
        event.preventDefault()
        send()
      }}
    >
      <div className={`grid items-end gap-2 grid-cols-1-auto narrow-grid-cols-1 ${classes.say}`}>
        <Textarea
          ref={field}
          label={`Your question about ${cue.name}`}
          placeholder="For example source, material, size, distance or mood"
          rows={1}
          classNames={{ input: fields.grows }}
          value={text}
          onChange={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) send()
          }}
        />
        <Button type="submit" disabled={ask.isPending || text.trim() === ''}>
          Ask
        </Button>
      </div>
      {text.trim() !== '' && <BlocksField checked={blocks} onChange={setBlocks} />}
      <DraftNote draft={draft} />
      <Refusal error={ask.error} />
    </form>
  )
}
