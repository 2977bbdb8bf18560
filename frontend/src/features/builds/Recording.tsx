import { useQueryClient } from '@tanstack/react-query'
import { useEffect, useMemo, useRef, useState, useSyncExternalStore } from 'react'

import { invalidate, queryKeys } from '@/api/queryKeys'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { partOf, type Reference, titleOf, useOpenVersion } from '@/references'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { ErrorBanner } from '@/ui/ErrorBanner'

import type { HeardAs, ListeningPass } from './api'
import { MomentRow } from './MomentRow'
import { type Moment, NO_MOMENTS, nameOfSound, soundOf, timeOf, withChange, withMoment, without } from './moments'
import { newNoteId, NoteQueue } from './noteQueue'
import classes from './Recording.module.css'
import { proposedDb } from './SoundToJudge'
import { SAID_WORDS, SAYINGS } from './words'

const GROUP = 'Recording'
const SOUNDS = 'recorded-sounds'
const STEP_S = 2

interface RecordingProps {
  reference: Reference
  listening: ListeningPass
  projectId: string
  personId: string
  /** Where a link leads to. */
  beginsAtS: number | undefined
}

/** A recording that plays; a key marks the moment with what is wrong, and the sound is named afterwards. */
export function Recording({ reference, listening, projectId, personId, beginsAtS }: RecordingProps) {
  const { version } = reference
  const { mutate: open, error } = useOpenVersion(projectId)
  const [isOpen, setOpen] = useState(false)
  const [isUnplayable, setUnplayable] = useState(false)
  useEffect(() => open(version.id, { onSuccess: () => setOpen(true) }), [open, version.id])
  const video = useRef<HTMLVideoElement>(null)
  const [now, setNow, draft] = useDraft(`recording:${listening.id}:${version.id}`, NO_MOMENTS)
  const { queue, kept } = useNoteQueue(projectId, personId)
  const named = now.moments.flatMap((moment) => {
    const sound = soundOf(moment.sound, listening.cues)
    return sound ? [{ moment, sound }] : []
  })

  const seek = (s: number) => {
    if (video.current) video.current.currentTime = Math.max(0, s)
  }
  const play = () => {
    const element = video.current
    if (element?.paused) void element.play().catch(() => undefined)
    else element?.pause()
  }
  const mark = (heardAs: HeardAs) => setNow((before) => withMoment(before, video.current?.currentTime ?? 0, heardAs))
  const last = now.moments.reduce<Moment | null>(
    (latest, moment) => (latest && latest.id > moment.id ? latest : moment),
    null,
  )
  const send = (only?: number) => {
    const going = named.filter(({ moment }) => only === undefined || moment.id === only)
    for (const { moment, sound } of going) {
      queue.add({
        kind: 'note',
        passId: listening.id,
        cueName: sound.cue.name,
        body: {
          note_id: newNoteId(),
          cue_id: sound.cue.id,
          said: moment.said,
          amount_db: proposedDb(moment.said, sound.suggested_db),
          text: moment.text.trim(),
          written_at: new Date().toISOString(),
          recording: { reference_version_id: version.id, at_s: moment.atS },
        },
      })
    }
    setNow((before) => without(before, new Set(going.map(({ moment }) => moment.id))))
  }
  useHotkeys([
    { keys: 'Space', label: 'Play or pause', group: GROUP, run: play },
    ...SAYINGS.map(({ said, word, keys }) => ({ keys, label: `${word}, here`, group: GROUP, run: () => mark(said) })),
    {
      keys: 'ArrowLeft',
      label: 'Two seconds back',
      group: GROUP,
      run: () => seek((video.current?.currentTime ?? 0) - STEP_S),
      repeats: true,
    },
    {
      keys: 'ArrowRight',
      label: 'Two seconds on',
      group: GROUP,
      run: () => seek((video.current?.currentTime ?? 0) + STEP_S),
      repeats: true,
    },
    {
      keys: 'u',
      label: 'Remove the last mark',
      group: GROUP,
      run: () => last && setNow((before) => without(before, new Set([last.id]))),
      disabled: last === null,
    },
    { keys: 'mod+Enter', label: 'Save notes', group: GROUP, run: () => send(), disabled: named.length === 0 },
  ])
  const waiting = kept.pending.length
  const notes = listening.notes.filter(({ recording }) => recording?.reference_version_id === version.id)
  const missing = now.moments.length - named.length
  return (
    <div className={`grid items-start gap-4 ${classes.stage}`}>
      <section aria-label="The recording" className={`grid gap-3 ${classes.picture}`}>
        <Refusal error={error} />
        {isUnplayable ? (
          <ErrorBanner
            detail={`This browser can’t play ${version.file_name}.`}
            fix="Add it to the references again as an MP4 with H.264 video."
          />
        ) : (
          // What was recorded comes as it is, without captions.
          // eslint-disable-next-line jsx-a11y/media-has-caption
          <video
            ref={video}
            src={isOpen ? partOf(version.id, 'file') : undefined}
            controls
            playsInline
            preload="metadata"
            aria-label={titleOf(reference)}
            onLoadedMetadata={() => beginsAtS !== undefined && seek(beginsAtS)}
            onError={() => setUnplayable(true)}
          />
        )}
        <div className={`flex wrap gap-2 ${classes.pads}`} role="group" aria-label="What is it like here?">
          {SAYINGS.map(({ said, word, keys, icon }) => (
            <Button key={said} tall icon={icon} keys={keys} onClick={() => mark(said)}>
              {word}
            </Button>
          ))}
        </div>
        <span className="wide-only">
          <KeysLine
            keys={[
              { keys: ['1', '7'], label: 'mark here' },
              { keys: ['ArrowLeft', 'ArrowRight'], label: 'two seconds' },
              { keys: ['u'], label: 'remove the last' },
            ]}
          />
        </span>
      </section>
      <Card aria-labelledby="moments">
        <CardHead id="moments" title="Marks" count={now.moments.length} />
        <DraftNote draft={draft} />
        {now.moments.length === 0 && (
          <p className="mid grid justify-items-start gap-2 p-2-14px">
            Play the recording, and press a key of what is wrong when you hear it. Name the sound later.
          </p>
        )}
        <datalist id={SOUNDS}>
          {listening.cues.map((entry) => (
            <option key={entry.cue.id} value={nameOfSound(entry)} />
          ))}
        </datalist>
        <ol>
          {now.moments.map((moment) => (
            <MomentRow
              key={moment.id}
              moment={moment}
              sound={soundOf(moment.sound, listening.cues)}
              sounds={SOUNDS}
              onSeek={() => seek(moment.atS)}
              onChange={(change) => setNow((before) => withChange(before, moment.id, change))}
              onRemove={() => setNow((before) => without(before, new Set([moment.id])))}
              onKeep={() => send(moment.id)}
            />
          ))}
        </ol>
        {now.moments.length > 0 && (
          <div className="grid justify-items-start gap-2 p-2-14px">
            {missing > 0 && (
              <p className="small mid">{`${plural(missing, 'mark')} without a sound ${missing === 1 ? 'stays' : 'stay'} here.`}</p>
            )}
            <Button variant="primary" keys="mod+Enter" disabled={named.length === 0} onClick={() => send()}>
              {named.length === 0 ? 'Save notes' : `Save ${plural(named.length, 'note')}`}
            </Button>
          </div>
        )}
        <p role="status" className="visually-hidden">
          {waiting > 0 && `${plural(waiting, 'note')} not sent yet.`}
        </p>
        {kept.refused.map(({ body, cueName, why }) => (
          <ErrorBanner
            key={body.note_id}
            detail={`${cueName}, ${SAID_WORDS[body.said].toLowerCase()} was not taken: ${why}.`}
          />
        ))}
        {kept.refused.length > 0 && <Button onClick={() => queue.forgetRefused()}>Dismiss</Button>}
      </Card>
      <Card aria-labelledby="recorded-notes">
        <CardHead id="recorded-notes" title="Notes of this recording" count={notes.length + waiting} />
        <ul>
          {notes.map(({ id, cue, said, text, recording, written_by: by }) => (
            <li key={id} className={`row border-t ${classes.note}`}>
              <Button
                variant="quiet"
                aria-label={`Play from ${timeOf(recording?.at_s ?? 0)}`}
                onClick={() => seek(recording?.at_s ?? 0)}
              >
                {timeOf(recording?.at_s ?? 0)}
              </Button>
              <p>
                <span className="strong">{cue.name}</span>{' '}
                {[SAID_WORDS[said].toLowerCase(), text, `from ${by.name}`].filter(Boolean).join(', ')}
              </p>
            </li>
          ))}
        </ul>
        {waiting > 0 && (
          <p className="small mid grid justify-items-start gap-2 p-2-14px">
            {`${plural(waiting, 'note')} kept in this browser, sent once the server answers.`}
          </p>
        )}
      </Card>
    </div>
  )
}

/** Notes on their way, kept in this browser until the server has them. */
function useNoteQueue(projectId: string, personId: string) {
  const client = useQueryClient()
  const queue = useMemo(
    () => new NoteQueue(personId, projectId, () => void invalidate(client, queryKeys.listening(projectId))),
    [client, personId, projectId],
  )
  useEffect(() => {
    if (queue.getState().pending.length > 0) void queue.send()
  }, [queue])
  return { queue, kept: useSyncExternalStore(queue.subscribe, queue.getState) }
}
