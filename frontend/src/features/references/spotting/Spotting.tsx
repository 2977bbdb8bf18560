import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import { useEffect, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { keptCuesQuery } from '@/api/soundList'
import { DraftNote, keepDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { partOf, type Reference, titleOf, useOpenVersion } from '@/references'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { ErrorBanner } from '@/ui/ErrorBanner'

import { guessQuery, useAddSpottedCues, useUndoSpottedCues } from './api'
import { ClipControls } from './ClipControls'
import { FRAME_RATES, nameOf, neighbour, USUAL_RATE, withChange, withoutMark, withShift } from './marks'
import { MarkRow } from './MarkRow'
import classes from './Spotting.module.css'
import { Timeline } from './Timeline'
import { useClip, usePosition } from './useClip'
import { draftKey, useMarks } from './useMarks'
import { useTap } from './useTap'

const GROUP = 'Spotting'
const CATEGORIES = 'spotting-categories'

/** A clip with its marks: tapped while it plays, put right, and made into cues. */
export function Spotting({ clip: reference }: { clip: Reference }) {
  const { id: referenceId, project_id: projectId, version } = reference
  const open = useOpenVersion(projectId)
  const { mutate: record } = open
  const [isOpen, setOpen] = useState(false)
  const [isUnplayable, setUnplayable] = useState(false)
  useEffect(() => record(version.id, { onSuccess: () => setOpen(true) }), [record, version.id])
  const video = useRef<HTMLVideoElement>(null)
  const source = isOpen ? partOf(version.id, 'file') : undefined
  const clip = useClip(video, source)
  const atS = usePosition(video, source)
  const { spotted, change, undo, mayUndo, draft } = useMarks(referenceId)
  const { marks } = spotted
  const [selected, setSelected] = useState<number | null>(null)
  const mark = marks.find(({ id }) => id === selected)
  const frameRate = spotted.frameRate ?? clip.measuredRate ?? USUAL_RATE
  const frameS = 1 / frameRate
  const tap = useTap({ clip, spotted, change, onMark: setSelected })
  const making = useMaking(reference, spotted, draft.discard)

  const nudge = (frames: number) => () => {
    if (mark === undefined) clip.seek(clip.positionAt() + frames * frameS)
    else change((now) => withShift(now, mark.id, frames * frameS), `nudge:${mark.id}`)
  }
  const select = (by: 1 | -1) => () => {
    const next = neighbour(marks, selected, by)
    if (next === undefined) return
    setSelected(next.id)
    clip.seek(next.startS)
  }
  const remove = (id: number) => {
    change((now) => withoutMark(now, id))
    setSelected(neighbour(marks, id, 1)?.id ?? null)
  }
  const beginHere = () => mark && change((now) => withChange(now, mark.id, { startS: clip.positionAt() }))
  const endHere = () => mark && change((now) => withChange(now, mark.id, { lengthS: clip.positionAt() - mark.startS }))
  const rename = () => document.querySelector<HTMLInputElement>(`[data-mark-name="${selected ?? ''}"]`)?.focus()
  const none = mark === undefined
  useHotkeys([
    { keys: 'Space', label: 'Play or pause', group: GROUP, run: clip.play },
    {
      keys: 't',
      label: 'Mark here; hold for a length',
      group: GROUP,
      run: (event) => tap.press(event.timeStamp),
      release: tap.release,
    },
    { keys: 'ArrowLeft', label: 'One frame earlier', group: GROUP, run: nudge(-1), repeats: true },
    { keys: 'ArrowRight', label: 'One frame later', group: GROUP, run: nudge(1), repeats: true },
    { keys: 'shift+ArrowLeft', label: 'Ten frames earlier', group: GROUP, run: nudge(-10), repeats: true },
    { keys: 'shift+ArrowRight', label: 'Ten frames later', group: GROUP, run: nudge(10), repeats: true },
    { keys: 'j', label: 'Next mark', group: GROUP, run: select(1), repeats: true },
    { keys: 'k', label: 'Previous mark', group: GROUP, run: select(-1), repeats: true },
    { keys: 'e', label: 'Name the mark', group: GROUP, run: rename, disabled: none },
    { keys: '[', label: 'The mark begins here', group: GROUP, run: beginHere, disabled: none },
    { keys: ']', label: 'The mark ends here', group: GROUP, run: endHere, disabled: none },
    { keys: 'x', label: 'Delete the mark', group: GROUP, run: () => mark && remove(mark.id), disabled: none },
    { keys: 'u', label: 'Undo', group: GROUP, run: undo, disabled: !mayUndo },
    { keys: 'Escape', label: 'Select no mark', group: GROUP, run: () => setSelected(null), disabled: none },
    { keys: 'mod+Enter', label: 'Make the cues', group: GROUP, run: () => void making.send() },
  ])
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const categories = [...new Set((cues ?? []).map(({ category }) => category).filter(Boolean))].toSorted()
  return (
    <>
      <div className={`grid items-start gap-4 mid-grid-cols-1 ${classes.stage}`}>
        <div className={`grid grid-cols-1 gap-3 ${classes.picture}`}>
          <Refusal error={open.error} />
          {isUnplayable ? (
            <ErrorBanner
              detail={`This browser can’t play ${version.file_name}.`}
              fix="Add it to the board again as an MP4 with H.264 video."
            />
          ) : (
            // What was sent comes as it is, without captions.
            // eslint-disable-next-line jsx-a11y/media-has-caption
            <video
              ref={video}
              src={source}
              playsInline
              preload="auto"
              aria-label={titleOf(reference)}
              onError={() => setUnplayable(true)}
            />
          )}
          <Timeline
            marks={marks}
            clipName={titleOf(reference)}
            durationS={clip.durationS}
            atS={atS}
            frameS={frameS}
            selected={selected}
            onSelect={setSelected}
            onSeek={clip.seek}
            onMove={(id, startS) => change((now) => withChange(now, id, { startS }), `drag:${id}`)}
          />
          <ClipControls
            video={video}
            isPlaying={clip.isPlaying}
            tap={tap}
            rates={FRAME_RATES}
            frameRate={frameRate}
            onPlay={clip.play}
            onFrameRate={(rate) => change((now) => ({ ...now, frameRate: rate }))}
            onNudge={(frames) => nudge(frames)()}
          />
          <span className="wide-only">
            <KeysLine
              keys={[
                { keys: ['t'], label: 'mark, hold for a length' },
                { keys: ['j', 'k'], label: 'next mark' },
                { keys: ['ArrowLeft', 'ArrowRight'], label: 'one frame' },
                { keys: ['[', ']'], label: 'begins, ends here' },
                { keys: ['e'], label: 'name' },
                { keys: ['x'], label: 'delete' },
              ]}
            />
          </span>
        </div>
        <Card aria-labelledby="marks">
          <CardHead
            id="marks"
            title="Marks"
            count={marks.length}
            end={
              <Button keys="u" disabled={!mayUndo} onClick={undo}>
                Undo
              </Button>
            }
          />
          <DraftNote draft={draft} />
          {marks.length === 0 && (
            <EmptyState head="No marks yet" level={3}>
              Play the clip and press t where a sound is needed. Hold it as long as the sound lasts.
            </EmptyState>
          )}
          <datalist id={CATEGORIES}>
            {categories.map((category) => (
              <option key={category} value={category} />
            ))}
          </datalist>
          <ol className="grid">
            {marks.map((item, at) => (
              <MarkRow
                key={item.id}
                mark={item}
                at={at}
                clipName={titleOf(reference)}
                projectId={projectId}
                isSelected={item.id === selected}
                faults={making.faultsOf(at)}
                categories={CATEGORIES}
                onSelect={() => setSelected(item.id)}
                onChange={(changed, field) => change((now) => withChange(now, item.id, changed), `${field}:${item.id}`)}
                onRemove={() => remove(item.id)}
              />
            ))}
          </ol>
          <div className="flex wrap items-center justify-end gap-3 p-3-4">
            <Refusal error={making.problem} />
            <Button
              variant="primary"
              keys="mod+Enter"
              disabled={marks.length === 0}
              aria-busy={making.isPending}
              onClick={() => void making.send()}
            >
              {marks.length === 0 ? 'Make cues' : `Make ${plural(marks.length, 'cue')}`}
            </Button>
          </div>
        </Card>
      </div>
    </>
  )
}

/** The marks become cues in one act; the notice takes them away again, and brings the marks back. */
function useMaking(reference: Reference, spotted: ReturnType<typeof useMarks>['spotted'], discard: () => void) {
  const { id: referenceId, project_id: projectId } = reference
  const client = useQueryClient()
  const navigate = useNavigate()
  const add = useAddSpottedCues(projectId, referenceId)
  const undo = useUndoSpottedCues(projectId, referenceId)
  const problem = add.error instanceof ApiProblem ? add.error : null
  const send = async () => {
    if (add.isPending || spotted.marks.length === 0) return
    const rows = await Promise.all(
      spotted.marks.map(async (mark, at) => {
        const name = mark.name.trim()
        const guessed = mark.category === null && name !== ''
        const category = guessed ? await client.fetchQuery(guessQuery(projectId, name)).catch(() => '') : mark.category
        return {
          name: nameOf(mark, at, titleOf(reference)),
          category: category ?? '',
          start_s: mark.startS,
          duration_s: mark.lengthS,
        }
      }),
    )
    add.mutate(rows, {
      onSuccess: (cues) => {
        discard()
        showToast(`${plural(cues.length, 'cue')} made from ${titleOf(reference)}.`, async () => {
          keepDraft(draftKey(referenceId), spotted, true) // before the cues go: the page may be left meanwhile
          await undo.mutateAsync(cues.map(({ id }) => id)).catch((refusal: unknown) => {
            keepDraft(draftKey(referenceId), null)
            throw refusal
          })
        })
        void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })
      },
    })
  }
  /** What was found wrong in one row, by field. */
  const faultsOf = (at: number): Record<string, string> => {
    const begin = `row ${at + 1}: `
    const own = problem?.errors.filter(({ field }) => field.startsWith(begin)) ?? []
    return Object.fromEntries(own.map(({ field, message }) => [field.slice(begin.length), message]))
  }
  return { send, problem, faultsOf, isPending: add.isPending }
}
