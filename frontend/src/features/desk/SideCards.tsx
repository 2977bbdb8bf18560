import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type DragEvent, useState } from 'react'

import { HotkeyButton } from '@/app/keys'
import { ShellLink } from '@/app/shell/ShellLink'
import { deemedAcceptanceNotice } from '@/verdicts/words'
import { fixesQuery } from '@/fixing'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ago, lengthAsked, plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'
import { useLazy } from '@/ui/useLazy'
import { filesOfDrop, type Picked } from '@/uploads'

import type { AskedQuestion, Desk, ToMake } from './api'
import { type DeskList, useWithApprover } from './pages'
import classes from './Side.module.css'

const SHOWN_AT_FIRST = 14
const loadApproved = () => import('./ApprovedVersions').then(({ ApprovedVersions }) => ApprovedVersions)
const loadAskForm = () => import('./AskForm').then(({ AskForm }) => AskForm)

interface ToMakeCardProps {
  projectId: string
  toMake: DeskList<ToMake>
  count: number
  onChoose: (cueId: string) => void
  onDrop: (picked: Picked[], cueId: string) => void
}

/** What is still to be made; each line takes a drop for its own cue. */
export function ToMakeCard({ projectId, toMake, count, onChoose, onDrop }: ToMakeCardProps) {
  const { items, hasMore, isFetching, showMore } = toMake
  const [all, setAll] = useState(false)
  const shown = all ? items : items.slice(0, SHOWN_AT_FIRST)
  return (
    <Card aria-labelledby="to-make">
      <CardHead
        id="to-make"
        title="To do"
        count={count > 0 ? count : undefined}
        end={count > 0 && <span className="wide-only">drop a file on a cue</span>}
      />
      {count === 0 && <p className="mid p-10px-inset">All cues have their files.</p>}
      <ul aria-labelledby="to-make">
        {shown.map((one) => (
          <ToMakeRow
            key={one.cue.id}
            projectId={projectId}
            one={one}
            onChoose={() => onChoose(one.cue.id)}
            onDrop={(picked) => onDrop(picked, one.cue.id)}
          />
        ))}
      </ul>
      {items.length > shown.length && (
        <p className="p-10px-inset">
          <button type="button" className="link small mid" onClick={() => setAll(true)}>
            {hasMore ? 'Show more' : `Show all ${items.length}`}
          </button>
        </p>
      )}
      {items.length === shown.length && hasMore && (
        <p className="p-10px-inset">
          <button type="button" className="link small mid" aria-busy={isFetching} onClick={showMore}>
            Show more
          </button>
        </p>
      )}
      <details className="small p-10px-inset">
        <summary>Files for your session</summary>
        {count > 0 && (
          <>
            <a className="link" href={`/v1/projects/${projectId}/desk/sounds.rpp`} download>
              REAPER project of what is owed
            </a>{' '}
            <span className="dim">a region for each file, change requests as markers</span>
            <br />
          </>
        )}
        <a className="link" href={`/v1/projects/${projectId}/spec.pdf`} target="_blank" rel="noreferrer">
          Delivery spec as a PDF
        </a>
      </details>
    </Card>
  )
}

function progress({ status, state, variations, missing }: ToMake) {
  if (state === 'concept') return <StatusBadge kind="warning">Concept</StatusBadge>
  if (status === 'question') return <StatusBadge kind="question" />
  if (status === 'placeholder') return <StatusBadge kind="placeholder" />
  if (variations > 1) return <span className="small mid nowrap">{`${missing} of ${variations} missing`}</span>
  return <StatusBadge kind="to_make" />
}

function factsOf({ category, use, loop, variations, state, ...lengths }: ToMake): string {
  if (state === 'concept') return 'not final; ask before you start'
  const facts = [
    use || category,
    lengthAsked(lengths),
    loop ? 'loop' : '',
    variations > 1 ? `set of ${variations}` : '',
  ]
  return facts.filter(Boolean).join(', ')
}

interface RowProps {
  projectId: string
  one: ToMake
  onChoose: () => void
  onDrop: (picked: Picked[]) => void
}

function ToMakeRow({ projectId, one, onChoose, onDrop }: RowProps) {
  const [over, setOver] = useState(false)
  const { cue } = one
  const take = (event: DragEvent) => {
    setOver(false)
    if (!event.dataTransfer.types.includes('Files')) return
    event.preventDefault()
    void filesOfDrop(event.dataTransfer).then(onDrop)
  }
  return (
    // The button in the row does the same without a drag.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <li
      className={`grid items-center hover border-b ${classes.make}`}
      data-over={over || undefined}
      onDragEnter={() => setOver(true)}
      onDragOver={(event) => event.preventDefault()}
      onDragLeave={(event) => {
        if (!event.currentTarget.contains(event.relatedTarget as Node | null)) setOver(false)
      }}
      onDrop={take}
    >
      <ShellLink className={`strong ${classes.cue}`} path={`/projects/${projectId}/sound-list/cues/${cue.id}`}>
        {cue.name}
      </ShellLink>
      {over ? <span className="small strong">For {cue.name}</span> : progress(one)}
      <span className="small dim">{factsOf(one)}</span>
      <Button
        square
        variant="quiet"
        icon="upload"
        className={classes.send}
        aria-label={`Choose files for ${cue.name}`}
        onClick={onChoose}
      />
    </li>
  )
}

/** What the designer need not think of now. */
export function WithApproverCard({ projectId, desk }: { projectId: string; desk: Desk }) {
  const { with_approver_cues: count, with_approver_files: files, accepted, cues: all } = desk
  const { items: cues, hasMore, isFetching, showMore } = useWithApprover(projectId, desk)
  const [isOpen, setOpen] = useState(false)
  const ApprovedVersions = useLazy(loadApproved, isOpen, () => setOpen(false))
  return (
    <Card aria-labelledby="with-approver">
      <CardHead
        id="with-approver"
        title="In review"
        end={
          <>
            {accepted} of {all} accepted{' '}
            <Button
              variant="quiet"
              aria-expanded={isOpen}
              aria-label={`${isOpen ? 'Hide' : 'Show'} approved versions`}
              onClick={() => setOpen(!isOpen)}
            >
              {isOpen ? 'Hide' : 'Show'}
            </Button>
          </>
        }
      />
      <div className={`grid wrap-anywhere grid-cols-1-auto p-2-inset ${classes.due}`}>
        {cues.length === 0 ? (
          <span className="mid">Nothing is in review.</span>
        ) : (
          <>
            <span className="mid">
              {cues.map(({ name }) => name).join(', ')}
              {hasMore && (
                <>
                  {' … '}
                  <button type="button" className="link small" aria-busy={isFetching} onClick={showMore}>
                    More in review
                  </button>
                </>
              )}
            </span>
            <StatusBadge kind="to_review">
              {plural(count, 'cue')}, {plural(files, 'file')}
            </StatusBadge>
            {waitsOf(cues).map((says) => (
              <p key={says} className="small mid col-span-full">
                {says}
              </p>
            ))}
          </>
        )}
      </div>
      {isOpen && ApprovedVersions && <ApprovedVersions projectId={projectId} />}
    </Card>
  )
}

/** For each day after which silence accepts: which cues, and when. */
function waitsOf(cues: readonly Desk['with_approver'][number][]): string[] {
  const waits = new Map<string, string[]>()
  for (const { name, accepted_after: day, silence_paused_by: pausedBy } of cues) {
    if (day === null) continue
    const says = deemedAcceptanceNotice(day, pausedBy)
    waits.set(says, [...(waits.get(says) ?? []), name])
  }
  return [...waits].map(([says, names]) => {
    const which = cues.length > 1 && names.length === cues.length ? 'Each' : names.join(', ')
    return `${which}: ${says}`
  })
}

/** What waits for the approver and could be better without a new export: the check warned, and a fix answers it. */
export function FixesCard({ projectId }: { projectId: string }) {
  const { data: offers } = useQuery(fixesQuery(projectId))
  const warned = offers?.filter(({ take_state: state }) => state === 'conforming') ?? []
  if (warned.length === 0) return null
  return (
    <Card aria-labelledby="fixes">
      <CardHead id="fixes" title="Auto-fix available" count={warned.length} end="warnings from the check" />
      <ul aria-labelledby="fixes">
        {warned.map(({ take_id: id, cue, variation, number, says }) => (
          <li key={id} className={`p-2-4 ${classes.fix}`}>
            <p>
              <Link className="link strong" to="/takes/$takeId" params={{ takeId: id }}>
                {cue.name}
                {variation > 1 && `_${String(variation).padStart(2, '0')}`}
              </Link>{' '}
              <span className="small dim">version {number}</span>
            </p>
            <p className="small mid">{says}</p>
          </li>
        ))}
      </ul>
    </Card>
  )
}

interface AskedCardProps {
  projectId: string
  questions: readonly AskedQuestion[]
  /** The selected cue, the default subject of a question. */
  cueId: string | null
}

/** Of the answered questions, the desk brings this many, the newest. */
const ANSWERED = 20

/** What was asked, what was answered, and the way to ask. */
export function AskedCard({ projectId, questions, cueId }: AskedCardProps) {
  const [asking, setAsking] = useState(false)
  const AskForm = useLazy(loadAskForm, asking, () => setAsking(false))
  const open = questions.filter(({ answer }) => answer === null).length
  const newest = questions.toSorted((a, b) => b.asked_at.localeCompare(a.asked_at))
  return (
    <Card aria-labelledby="asked">
      <CardHead
        id="asked"
        title="Your questions"
        note={open > 0 ? `${open} open` : undefined}
        end={
          !asking && (
            <HotkeyButton
              icon="question"
              variant="quiet"
              keys="q"
              keyLabel="Ask about a cue"
              keyGroup="Desk"
              onPress={() => setAsking(true)}
            >
              Ask
            </HotkeyButton>
          )
        }
      />
      {asking && AskForm && <AskForm projectId={projectId} cueId={cueId} onDone={() => setAsking(false)} />}
      {!asking && newest.length === 0 && (
        <p className="mid p-10px-inset">
          No questions yet. Ask about source, material or size. Answers are added to the cue.
        </p>
      )}
      <ul aria-labelledby="asked">
        {newest.map(({ id, cue, text, asked_at, answer }) => (
          <li key={id} className={`border-b wrap-anywhere p-2-inset ${classes.question}`}>
            <p>“{text}”</p>
            <p className="small dim">
              {cue.name}, {ago(asked_at)}
              {answer === null ? ', waiting for the studio' : ''}
            </p>
            {answer !== null && <p className={`mt-1 ${classes.answer}`}>{answer}</p>}
          </li>
        ))}
      </ul>
      {newest.length - open >= ANSWERED && (
        <p className="small dim p-10px-inset">Earlier answers are with their cues.</p>
      )}
    </Card>
  )
}
