import { Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type ReactNode, useState } from 'react'

import { projectQuery } from '@/api/project'
import { DraftForm } from '@/app/drafts/DraftForm'
import { Button } from '@/ui/Button'
import { CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { Field, Submit } from '@/ui/Form'
import { day, today } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'

import { type Brief, type Decision, decisionsQuery, useRemoveDecision, useSaveDecision } from './api'
import classes from './Brief.module.css'
import { questionsOf } from './words'

/** What was decided before the contract, on which day and by whom; it can be changed until a contract is signed. */
export function KickOffCard({ projectId, brief }: { projectId: string; brief: Brief }) {
  const { data: decisions, error } = useQuery(decisionsQuery(projectId))
  const remove = useRemoveDecision(projectId)
  const [editing, setEditing] = useState<string | null>(null)
  if (!decisions || (decisions.length === 0 && !brief.may_answer)) return <Refusal error={error} />
  return (
    <section aria-label="Kick-off">
      <CardHead title="Kick-off" count={decisions.length} />
      <ul aria-label="Decisions">
        {decisions.map((decision) => (
          <li key={decision.id} className="grid gap-2px border-b wrap-anywhere p-2-inset">
            {editing === decision.id ? (
              <DecisionForm
                key={decision.id}
                projectId={projectId}
                decision={decision}
                onDone={() => setEditing(null)}
              />
            ) : (
              <>
                <span className="small mid">{`${day(decision.decided_on)} · ${decision.attended}`}</span>
                <span>
                  <Linked text={decision.text} projectId={projectId} brief={brief} />
                </span>
                {decision.signed_at !== null && <span className="small dim">In the record of a contract</span>}
                {brief.may_answer && decision.signed_at === null && (
                  <span className="row">
                    <Button variant="quiet" onClick={() => setEditing(decision.id)}>
                      Edit
                    </Button>
                    <ConfirmInline
                      variant="quiet"
                      action="Delete decision"
                      about={decision.text}
                      onConfirm={() => remove.mutate(decision.id)}
                    >
                      Delete
                    </ConfirmInline>
                  </span>
                )}
              </>
            )}
          </li>
        ))}
      </ul>
      <div className={classes.sideBody}>
        <Refusal error={remove.error} />
        {brief.may_answer &&
          (editing === 'new' ? (
            <DecisionForm projectId={projectId} onDone={() => setEditing(null)} />
          ) : (
            <div>
              <Button onClick={() => setEditing('new')}>Add decision</Button>
            </div>
          ))}
      </div>
    </section>
  )
}

interface DecisionFormProps {
  projectId: string
  /** None: a new one. */
  decision?: Decision
  onDone: () => void
}

function DecisionForm({ projectId, decision, onDone }: DecisionFormProps) {
  const save = useSaveDecision(projectId)
  return (
    <DraftForm
      className="stack"
      aria-label={decision ? 'Edit decision' : 'New decision'}
      draftKey={`decision:${projectId}:${decision?.id ?? 'new'}`}
      initialValues={{
        decided_on: decision?.decided_on ?? today(),
        attended: decision?.attended ?? '',
        text: decision?.text ?? '',
      }}
      mutation={save}
      onSubmit={(body, onSent) =>
        save.mutate(
          { id: decision?.id, body },
          {
            onSuccess: () => {
              onSent()
              onDone()
            },
          },
        )
      }
    >
      <Field name="decided_on" type="date" label="Date" />
      <Field name="attended" label="Attended" description="Everyone in the project reads this." maxLength={120} />
      <Field
        as={Textarea}
        name="text"
        label="Decision"
        description="Name cues and questions by their numbers: SW-014, question 4."
        rows={2}
        maxLength={2000}
      />
      <Submit onCancel={onDone}>Save decision</Submit>
    </DraftForm>
  )
}

const NUMBERED = /\b(question \d{1,3}|[A-Z][A-Z0-9]{0,9}-\d{1,6})\b/i

/** A text whose questions and cues are links. */
function Linked({ text, projectId, brief }: { text: string; projectId: string; brief: Brief }): ReactNode {
  const { data: project } = useQuery(projectQuery(projectId))
  return text.split(NUMBERED).map((part, place) => {
    if (place % 2 === 0) return part
    const isQuestion = /^question /i.test(part)
    const number = Number(part.split(' ')[1])
    const question = isQuestion ? questionsOf(brief).find((candidate) => candidate.number === number) : undefined
    if (question) {
      const topic = brief.topics.find(({ questions }) => questions.includes(question))?.key
      return (
        <Link key={place} className="link" to="/projects/$projectId/brief" params={{ projectId }} search={{ topic }}>
          {part}
        </Link>
      )
    }
    if (isQuestion || part.split('-')[0]?.toLowerCase() !== project?.cue_prefix.toLowerCase()) return part
    return (
      <Link
        key={place}
        className="link mono"
        to="/projects/$projectId/sound-list"
        params={{ projectId }}
        search={{ q: part }}
      >
        {part}
      </Link>
    )
  })
}
