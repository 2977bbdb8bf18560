import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'

import { type TrayWork, type UndecidedPlace, useTrayWork, useUndecidedFiles, useUndo } from './api'
import { CueField } from './CueField'
import { actionLine, files } from './tray'
import classes from './Unmatched.module.css'

/** Several files of one delivery for one sound: which counts, or whether they are alternates, a person says. */
export function UndecidedFiles({ projectId }: { projectId: string }) {
  const { data: places = [] } = useUndecidedFiles(projectId)
  const work = useTrayWork(projectId)
  const undo = useUndo(projectId)
  const act = (asked: TrayWork, said?: string) =>
    work.mutate(asked, {
      onSuccess: (done) =>
        showToast(said ?? actionLine(done), async () => {
          const { left } = await undo.mutateAsync(done)
          if (left > 0) showToast(`${files(left)} changed since then and stayed.`)
        }),
    })
  if (places.length === 0) return null
  const isBusy = work.isPending || undo.isPending
  return (
    <section aria-label="Files to choose between" aria-busy={isBusy}>
      <div className={`flex wrap items-center gap-2-3 ${classes.bar}`}>
        <StatusBadge kind="question">{plural(places.length, 'sound')} with several files</StatusBadge>
        <span className="small mid">They came in one delivery, and only one can be the sound. Say what they are.</span>
      </div>
      {(work.error ?? undo.error) !== null && (
        <div className="p-3-inset">
          <Refusal error={work.error ?? undo.error} />
        </div>
      )}
      {places.map((place) => (
        <Place key={place.takes[0]?.id} projectId={projectId} place={place} isBusy={isBusy} onAct={act} />
      ))}
    </section>
  )
}

interface PlaceProps {
  projectId: string
  place: UndecidedPlace
  isBusy: boolean
  onAct: (work: TrayWork, said?: string) => void
}

function Place({ projectId, place: { cue, variation, takes }, isBusy, onAct }: PlaceProps) {
  const [movingId, setMovingId] = useState<string | null>(null)
  const name = `${cue.label} ${cue.name}, variation ${variation}`
  const others = takes.slice(1)
  return (
    <div className="p-3-inset" role="group" aria-label={name}>
      <p>
        <span className="mono dim">{cue.label}</span> <span className="strong">{cue.name}</span>{' '}
        <span className="mid">variation {variation}: which file is it?</span>
      </p>
      <ul>
        {takes.map(({ id, file_name: fileName, number }) => (
          <li key={id} className={`row wrap ${classes.acts}`}>
            <span className="mono wrap-anywhere">{fileName}</span>
            <span className="small mid">version {number}</span>
            <Button
              disabled={isBusy}
              aria-label={`Use ${fileName}`}
              onClick={() => {
                const rest = takes.filter((take) => take.id !== id)
                onAct(
                  { what: 'discard', takeIds: rest.map((take) => take.id) },
                  `${fileName} counts; ${files(rest.length)} discarded, ${rest.length === 1 ? 'its master is' : 'their masters are'} kept.`,
                )
              }}
            >
              Use this one
            </Button>
            <Button
              variant="quiet"
              disabled={isBusy}
              pressed={movingId === id}
              aria-label={`${fileName} is for another cue`}
              onClick={() => setMovingId(movingId === id ? null : id)}
            >
              Other cue…
            </Button>
            <Button
              variant="quiet"
              disabled={isBusy}
              aria-label={`Discard ${fileName}`}
              onClick={() => onAct({ what: 'discard', takeIds: [id] })}
            >
              Discard
            </Button>
            {movingId === id && (
              <CueField
                projectId={projectId}
                label={`Cue for ${fileName}`}
                one
                onBack={() => setMovingId(null)}
                onPick={(picked, pickedVariation) =>
                  onAct(
                    {
                      what: 'move',
                      moves: [{ take_id: id, cue_id: picked.id, variation: pickedVariation }],
                    },
                    `${fileName} is for ${picked.name} and will be named for it.`,
                  )
                }
              />
            )}
          </li>
        ))}
      </ul>
      <Button
        disabled={isBusy}
        onClick={() =>
          onAct(
            {
              what: 'move',
              moves: others.map(({ id }) => ({ take_id: id, cue_id: cue.id, variation, as_alternate: true })),
            },
            `${files(takes.length)} are alternates of ${cue.name}; the approver picks one.`,
          )
        }
      >
        {takes.length === 2 ? 'Both are alternates' : `All ${takes.length} are alternates`}
      </Button>
    </div>
  )
}
