import { Link } from '@tanstack/react-router'
import { useId, useState } from 'react'

import { useRoles } from '@/api/roles'
import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { WaveThumb } from '@/audio'
import { isNoted } from '@/verdicts/afterVerdict'
import type { QueueItem } from '@/verdicts/api'
import { whyBlocked } from '@/verdicts/blocked'
import type { Queue } from '@/verdicts/useQueue'
import { heardTakes, describeWaiting } from '@/verdicts/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { age } from '@/ui/format'
import { Key } from '@/ui/Key'
import { Person } from '@/ui/Person'
import { StatusBadge } from '@/ui/StatusBadge'

import { type AskedQuestion, useAnswer } from './api'
import classes from './Today.module.css'

interface UpNextListProps {
  items: readonly QueueItem[]
  questions: readonly AskedQuestion[]
  projectId: string
  /** Whether the current person decides on these cues, and so reads what blocks that. */
  mayApprove: boolean
  title: string
  /** The queue, where more of it waits than is here. */
  beyond?: Queue
}

type Line = { item: QueueItem; question?: undefined } | { item?: undefined; question: AskedQuestion }

/** Cues in the order of the queue; each question before the first cue that is not urgent and has waited less. */
function inOrder(items: readonly QueueItem[], questions: readonly AskedQuestion[]): Line[] {
  const lines: Line[] = []
  const asked = questions.toSorted((a, b) => a.asked_at.localeCompare(b.asked_at))
  for (const item of items) {
    while (asked[0] && !item.is_urgent && asked[0].asked_at < item.waiting_since) {
      lines.push({ question: asked[0] })
      asked.shift()
    }
    lines.push({ item })
  }
  return [...lines, ...asked.map((question) => ({ question }))]
}

/** What waits after the first thing: cues to review in the order of the queue, and questions among them. */
export function UpNextList({ items, questions, projectId, mayApprove, title, beyond }: UpNextListProps) {
  const headId = useId()
  const lines = inOrder(items, questions)
  return (
    <Card aria-labelledby={headId}>
      <CardHead
        id={headId}
        title={title}
        count={beyond ? `${lines.length}+` : lines.length}
        end={<span className="wide-only">urgent, need, priority, then oldest</span>}
      />
      <ul>
        {lines.map(({ item, question }) =>
          item ? (
            <CueLine key={item.cue.id} item={item} projectId={projectId} mayApprove={mayApprove} />
          ) : (
            question && <QuestionLine key={question.id} question={question} projectId={projectId} />
          ),
        )}
      </ul>
      {beyond && (
        <p className={`border-t ${classes.more}`}>
          <button type="button" className="link small mid" onClick={() => void beyond.readOn()}>
            Show more
          </button>
        </p>
      )}
    </Card>
  )
}

function CueLine({ item, projectId, mayApprove }: { item: QueueItem; projectId: string; mayApprove: boolean }) {
  const { cue } = item
  const waits = describeWaiting(item)
  const blocked = mayApprove ? blockedOf(item) : ''
  return (
    <li>
      <Link
        data-stop
        className={`grid items-center gap-3 hover pointer w-full narrow-grid-cols-1-auto ${classes.line}`}
        to="/projects/$projectId/review/$cueId"
        params={{ projectId, cueId: cue.id }}
      >
        <span className="mono dim wide-only">{cue.label}</span> <span className="strong cut-text">{cue.name}</span>{' '}
        <span className={`mid cut-text ${classes.why}`}>
          {blocked && <span className="tone-warn toned">{blocked}. </span>}
          {waits.before}
          {waits.odd && <span className="tone-warn toned">{waits.odd}</span>}
          {waits.after}
          {item.kind === 'set' && !waits.odd && (
            <span className="wide-only">
              ; hold <Key keys="h" /> to play it randomised, as in game
            </span>
          )}
        </span>
        <span className="wide-only grid">
          <WaveThumb peaks={heardTakes(item)[0]?.thumb ?? null} heightPx={26} />
        </span>
        <span className="wide-only">
          {isNoted(item) ? (
            <StatusBadge kind="change_requested">Draft, not sent</StatusBadge>
          ) : (
            <StatusBadge kind="to_review" />
          )}
        </span>
        <span className="dim num small nowrap">{age(item.waiting_since)}</span>
      </Link>
    </li>
  )
}

/** "Not to be approved yet: 1 comment is not resolved", or how many of several versions. */
function blockedOf(item: QueueItem): string {
  const why = whyBlocked(item.blocked)
  const open = heardTakes(item).flatMap(({ id }) => why.get(id) ?? [])
  if (open.length === 0) return ''
  const which = item.takes.length === 1 ? 'Not' : `${open.length} of ${item.takes.length} not`
  return `${which} to be approved yet: ${open[0] ?? ''}`
}

function QuestionLine({ question, projectId }: { question: AskedQuestion; projectId: string }) {
  const [open, setOpen] = useState(false)
  const { cue } = question
  const placeId = useId()
  const roleOf = useRoles(projectId)
  return (
    <li>
      <button
        type="button"
        data-stop
        className={`grid items-center gap-3 hover pointer w-full narrow-grid-cols-1-auto ${classes.line}`}
        aria-expanded={open}
        aria-controls={placeId}
        onClick={() => setOpen(!open)}
      >
        <span className="mono dim wide-only">{cue.label}</span> <span className="strong cut-text">{cue.name}</span>{' '}
        <span className={`mid ${open ? '' : 'cut-text'} ${classes.why}`}>“{question.text}”</span>
        <span className="small mid wide-only grid">
          <Person
            name={question.asked_by.name}
            picture={question.asked_by.picture}
            role={roleOf(question.asked_by.id)}
          />
        </span>
        <span className="wide-only">
          <StatusBadge kind="question" />
        </span>
        <span className="dim num small nowrap">{age(question.asked_at)}</span>
      </button>
      <div id={placeId}>
        {open && <Answer question={question} projectId={projectId} onClose={() => setOpen(false)} />}
      </div>
    </li>
  )
}

interface AnswerProps {
  question: AskedQuestion
  projectId: string
  onClose: () => void
}

function Answer({ question, projectId, onClose }: AnswerProps) {
  const [text, setText, draft] = useDraft(`answer:${question.id}`, '')
  const answer = useAnswer(projectId, question.id)
  const roleOf = useRoles(projectId)
  const trimmed = text.trim()
  const send = () => {
    if (trimmed === '' || answer.isPending) return
    answer.mutate(trimmed, {
      onSuccess: () => {
        draft.discard()
        showToast(`Answered. It was added to the description of ${question.cue.name}.`)
      },
    })
  }
  return (
    <form
      className="grid gap-2 border-b p-3-inset bg-surface"
      onSubmit={(event) => {
        event.preventDefault()
        send()
      }}
    >
      <p className="small dim">
        <Person name={question.asked_by.name} picture={question.asked_by.picture} role={roleOf(question.asked_by.id)} />{' '}
        asks. The answer is added to the description of {question.cue.name}.
      </p>
      <div className="flex gap-2">
        <input
          // The line was opened to be written in.
          // eslint-disable-next-line jsx-a11y/no-autofocus
          autoFocus
          className={`line-field flex-1 ${classes.answerText}`}
          aria-label={`Answer for ${question.cue.name}`}
          maxLength={4000}
          value={text}
          onChange={(event) => setText(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Escape') onClose()
          }}
        />
        <Button variant="primary" type="submit" keys="Enter" disabled={answer.isPending}>
          Answer
        </Button>
      </div>
      <DraftNote draft={draft} />
      <Refusal error={answer.error} />
    </form>
  )
}
