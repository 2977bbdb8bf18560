import { Link } from '@tanstack/react-router'
import { useMemo, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { Refusal } from '@/ui/Refusal'
import { countOf, figure, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { KeysLine } from '@/ui/KeysLine'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Segmented } from '@/ui/Segmented'

import { type CueToHear, type ListeningPass, useClosePass } from './api'
import classes from './Listening.module.css'
import { groupOf, inOrder, keepOrder, keptOrder, type Order, ORDER_WORDS, ORDERS } from './listeningOrder'
import { SoundToJudge } from './SoundToJudge'
import { type ShownNote, useNotes } from './useNotes'
import { SAID_WORDS, SAYINGS, signed, taskOf } from './words'

const GROUP = 'Listening pass'
const UNHEARD = new Set(['missing', 'not-reached'])

/** Where a pass goes on: at the first cue that nobody heard and I said nothing of. */
function firstOpen(cues: readonly CueToHear[], notes: readonly ShownNote[]): number {
  const noted = new Set(notes.filter(({ isMine }) => isMine).map(({ cueId }) => cueId))
  const at = cues.findIndex(({ cue, heard }) => !heard && !noted.has(cue.id))
  return Math.max(0, at)
}

/** One sound after the other: what it is like in the game, in one key, and the next. */
export function ListeningRoom({ listening, projectId }: { listening: ListeningPass; projectId: string }) {
  const { audit } = listening
  const [order, setOrder] = useState(keptOrder)
  const cues = useMemo(() => inOrder(listening.cues, order), [listening.cues, order])
  const notes = useNotes(projectId, listening)
  const [at, setAt] = useState(() => firstOpen(cues, notes.notes))
  const cue = cues[Math.min(at, cues.length - 1)]
  const heard = useMemo(() => {
    const noted = notes.notes.filter(({ said: heardAs }) => !UNHEARD.has(heardAs)).map(({ cueId }) => cueId)
    const others = cues.filter(
      (entry) => entry.heard && !notes.notes.some(({ cueId, isMine }) => isMine && cueId === entry.cue.id),
    )
    return new Set([...noted, ...others.map((entry) => entry.cue.id)])
  }, [cues, notes.notes])
  const last = notes.notes.find(({ isMine }) => isMine)
  const step = (by: number) => setAt(Math.min(cues.length - 1, Math.max(0, at + by)))
  const group = (next: Order) => {
    const now = cues[at]?.cue.id
    keepOrder(next)
    setOrder(next)
    setAt(
      Math.max(
        0,
        inOrder(listening.cues, next).findIndex((entry) => entry.cue.id === now),
      ),
    )
  }
  const undo = () => {
    if (!last) return
    notes.takeBack(last)
    setAt(
      Math.max(
        0,
        cues.findIndex(({ cue: { id } }) => id === last.cueId),
      ),
    )
    showToast(`${last.cueName}: undone.`)
  }
  useHotkeys([
    { keys: 'j', label: 'Next sound, without a note', group: GROUP, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous sound', group: GROUP, run: () => step(-1), repeats: true },
    {
      keys: 'o',
      label: 'Group by list, category or event',
      group: GROUP,
      run: () => group(ORDERS[(ORDERS.indexOf(order) + 1) % ORDERS.length] ?? 'list'),
    },
    { keys: 'u', label: 'Undo last note', group: GROUP, run: undo, disabled: !last },
  ])
  if (!cue) return <NoCues projectId={projectId} label={audit.label} />
  return (
    <div className={`grid overflow-hidden ${classes.room}`}>
      <aside className={`wide-only border-r ${classes.list}`} aria-label="Sounds of the build">
        <Head listening={listening} heard={heard.size} notes={notes.notes.length} />
        <div className="border-b p-2-14px">
          <Segmented
            label="Group by"
            value={order}
            options={ORDERS.map((value) => ({ value, label: ORDER_WORDS[value] }))}
            onChange={group}
          />
        </div>
        <ol className="flex-1 min-h-0 overflow-y-auto">
          {cues.map((entry, index) => (
            <li key={entry.cue.id}>
              <Heading
                group={groupOf(entry, order)}
                before={index > 0 ? groupOf(cues[index - 1] ?? entry, order) : ''}
              />
              <button
                type="button"
                className={`grid gap-2 hover pointer w-full grid-cols-1-auto ${classes.item}`}
                aria-current={index === at || undefined}
                onClick={() => setAt(index)}
              >
                <span className="cut-text">{entry.cue.name}</span>
                <span className="small dim">{standing(entry, notes.notes, heard)}</span>
              </button>
            </li>
          ))}
        </ol>
        <div className={classes.hints}>
          <KeysLine
            keys={[
              { keys: ['j', 'k'], label: 'next, previous' },
              { keys: ['u'], label: 'take back' },
              { keys: ['o'], label: 'group' },
              { keys: ['Space'], label: 'play' },
            ]}
          />
        </div>
      </aside>
      <div className={`flex flex-col gap-3 min-w-0 overflow-y-auto bg-raised ${classes.judge}`}>
        <header className={`${classes.phoneHead} small`}>
          <h1 className="small strong">{`Listening pass, ${at + 1} of ${cues.length}, build ${audit.label}`}</h1>
          <span>{`${countOf(heard.size, cues.length)} heard`}</span>
        </header>
        <span className={classes.phoneBar} aria-hidden="true">
          <i style={{ width: `${(heard.size / cues.length) * 100}%` }} />
        </span>
        <Waiting waiting={notes.waiting} />
        {notes.refused.map(({ body, cueName, why }) => (
          <ErrorBanner
            key={body.note_id}
            detail={`${cueName}, ${SAID_WORDS[body.said].toLowerCase()}${body.text ? `: ${body.text}` : ''} was not taken: ${why}.`}
          />
        ))}
        {notes.refused.length > 0 && <Button onClick={notes.forgetRefused}>Dismiss</Button>}
        <SoundToJudge
          key={cue.cue.id}
          cue={cue}
          projectId={projectId}
          passId={listening.id}
          buildLabel={audit.label}
          said={notes.notes.find(({ cueId, isMine, isMoment }) => isMine && !isMoment && cueId === cue.cue.id)}
          next={cues[at + 1]?.cue.name}
          onSay={(heardAs, amountDb, text) => {
            notes.say(cue.cue, heardAs, amountDb, text)
            step(1)
          }}
          onUndo={last ? undo : undefined}
        />
      </div>
      <aside className={`border-l ${classes.notes}`} aria-label="Notes of this pass">
        <header className={`row between border-b flex-none ${classes.head}`}>
          <h2>Notes of this pass</h2>
          <span className="dim">{figure(notes.notes.length)}</span>
        </header>
        <ul className="flex-1 min-h-0 overflow-y-auto">
          {notes.notes.map((note) => (
            <NoteRow key={note.id} note={note} />
          ))}
        </ul>
        <Foot listening={listening} projectId={projectId} />
      </aside>
    </div>
  )
}

/** The name of a group, before its first sound. */
function Heading({ group, before }: { group: string; before: string }) {
  return group !== before && <h2 className={`small strong wrap-anywhere ${classes.group}`}>{group}</h2>
}

function standing({ cue }: CueToHear, notes: readonly ShownNote[], heard: ReadonlySet<string>): string {
  const note = notes.find(({ cueId }) => cueId === cue.id)
  if (note) return SAID_WORDS[note.said]
  return heard.has(cue.id) ? 'heard' : 'not heard'
}

function Head({ listening, heard, notes }: { listening: ListeningPass; heard: number; notes: number }) {
  const { cues, audit } = listening
  return (
    <>
      <header className={`row between border-b flex-none ${classes.head}`}>
        <h1 className="strong">Listening pass</h1>
        <span className="small dim">{`build ${audit.label}`}</span>
      </header>
      <div className={`grid gap-6px border-b ${classes.sum}`}>
        <p className="row between">
          <span className="strong">{`${countOf(heard, cues.length)} heard`}</span>
          <span className="small dim">{plural(notes, 'note')}</span>
        </p>
        <span className={classes.bar} role="img" aria-label={`Heard: ${countOf(heard, cues.length)}`}>
          <i style={{ width: `${(heard / Math.max(1, cues.length)) * 100}%` }} />
        </span>
      </div>
    </>
  )
}

/** Notes that are still here: counted, so that nobody wonders whether they are lost. */
function Waiting({ waiting }: { waiting: number }) {
  return (
    <p
      role="status"
      className={waiting > 0 ? `small flex gap-6px items-center rounded ${classes.waiting}` : 'visually-hidden'}
    >
      {waiting > 0 && (
        <>
          <Icon name="pause" size={14} />
          {`${plural(waiting, 'note')} kept in this browser, sent in order once the server answers.`}
        </>
      )}
    </p>
  )
}

function NoteRow({ note }: { note: ShownNote }) {
  const face = SAYINGS.find(({ said }) => said === note.said)
  const task = taskOf(note.said)
  return (
    <li className={`grid gap-10px wrap-anywhere border-b ${classes.note}`}>
      <span className="tone-change toned">
        <Icon name={note.isDone ? 'tick' : (face?.icon ?? 'ring')} />
      </span>
      <div>
        <p className="strong">{note.cueName}</p>
        <p className="small">
          {[SAID_WORDS[note.said], note.amountDb === null ? '' : signed(note.amountDb), note.text]
            .filter(Boolean)
            .join(', ')}
        </p>
        <p className="small dim">
          {[task && (note.isDone ? 'done' : task.toLowerCase()), `from ${note.by}`, note.isWaiting && 'not sent yet']
            .filter(Boolean)
            .join(', ')}
        </p>
      </div>
    </li>
  )
}

function Foot({ listening, projectId }: { listening: ListeningPass; projectId: string }) {
  const close = useClosePass(projectId)
  return (
    <div className={classes.foot}>
      <Link className="link small" to="/projects/$projectId/game-tasks" params={{ projectId }}>
        All tasks
      </Link>
      <Link className="link small" to="/projects/$projectId/recording" params={{ projectId }}>
        Mark in a recording
      </Link>
      {!listening.is_newest && <p className="small mid">A newer build was audited. The next pass begins with it.</p>}
      {listening.may_close && (
        <ConfirmInline action="Close pass (notes and tasks are kept)" onConfirm={() => close.mutate(listening.id)}>
          Close the pass
        </ConfirmInline>
      )}
      <Refusal error={close.error} />
    </div>
  )
}

function NoCues({ projectId, label }: { projectId: string; label: string }) {
  return (
    <div className="page stack">
      <h1>Listening pass</h1>
      <p className="mid">
        {`Build ${label} has no sound of a cue that you hear.`}{' '}
        <Link className="link" to="/projects/$projectId/game-tasks" params={{ projectId }}>
          Tasks
        </Link>
      </p>
    </div>
  )
}
