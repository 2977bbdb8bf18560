import { useMemo, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import type { Player, PlayerState } from '@/audio'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Take, type TrayWork, useTrayWork, useUndo } from './api'
import { CueField } from './CueField'
import { actionLine, between, files, type FolderMatch, folderMatch, groupsOf } from './tray'
import classes from './Unmatched.module.css'
import { UnmatchedFile } from './UnmatchedFile'

interface TrayProps {
  projectId: string
  takes: readonly Take[]
  /** As the headline counts them. */
  count: number
  player: Player
  playing: PlayerState
}

const SHOWN = 40

/** Files that no cue owns by name: sure ones accepted at once, guesses chosen by a person, many moved or discarded. */
export function UnmatchedTray({ projectId, takes, count, player, playing }: TrayProps) {
  const [later, setLater] = useState<ReadonlySet<string>>(new Set())
  const [chosen, setChosen] = useState<ReadonlySet<string>>(new Set())
  const [at, setAt] = useState<string | null>(null)
  const [shown, setShown] = useState(SHOWN)
  const [moving, setMoving] = useState(false)
  const [openFolder, setOpenFolder] = useState<string | null>(null)
  const work = useTrayWork(projectId)
  const undo = useUndo(projectId)

  const groups = useMemo(() => groupsOf(takes.filter(({ id }) => !later.has(id))), [takes, later])
  const now = useMemo(() => groups.flatMap(({ takes: of }) => of), [groups])
  const sure = takes.filter((take) => take.sure !== null).map(({ id }) => id)
  const selected = now.filter(({ id }) => chosen.has(id)).map(({ id }) => id)
  const current = now.find(({ id }) => id === at) ?? now[0]
  const kept = takes.length - now.length
  const busy = work.isPending || undo.isPending

  const act = (asked: TrayWork, said?: string) =>
    work.mutate(asked, {
      onSuccess: (done) => {
        setChosen(new Set())
        setMoving(false)
        setOpenFolder(null)
        const back = async () => {
          const { left } = await undo.mutateAsync(done)
          if (left > 0) showToast(`${files(left)} changed since then and stayed.`)
        }
        showToast(said ?? actionLine(done), back)
      },
    })
  const moveFolder = (folder: string, { cue, moves }: FolderMatch) =>
    act(
      { what: 'move', moves },
      `${files(moves.length)} of ${folder} ${moves.length === 1 ? 'is' : 'are'} for ${cue.name}.`,
    )
  const currentGroup = groups.find(({ folder, takes: of }) => folder !== '' && current && of.includes(current))
  const currentMatch = currentGroup ? folderMatch(currentGroup.takes) : null
  const choose = (ids: readonly string[], on: boolean) =>
    setChosen((before) => new Set(on ? [...before, ...ids] : [...before].filter((id) => !ids.includes(id))))
  const toggle = (take: Take, ranged: boolean) => {
    const ids = ranged && at !== null ? between(now, at, take.id) : [take.id]
    choose(ids, ranged || !chosen.has(take.id))
    setAt(take.id)
  }
  const step = (by: number) => {
    const place = current ? now.indexOf(current) + by : 0
    const next = now[Math.max(0, Math.min(now.length - 1, place))]
    if (!next) return null
    setAt(next.id)
    document.getElementById(`tray-${next.id}`)?.scrollIntoView({ block: 'nearest' })
    return next
  }
  const stretch = (by: number) => {
    if (current) choose([current.id], true)
    const next = step(by)
    if (next) choose([next.id], true)
  }

  useHotkeys([
    {
      keys: 'x',
      label: 'Select the file',
      group: 'Tray',
      disabled: !current,
      run: () => current && toggle(current, false),
    },
    { keys: 'ArrowDown', label: 'Next file', group: 'Tray', disabled: !current, run: () => void step(1) },
    { keys: 'ArrowUp', label: 'File before', group: 'Tray', disabled: !current, run: () => void step(-1) },
    { keys: 'shift+ArrowDown', label: 'Select the next too', group: 'Tray', disabled: !current, run: () => stretch(1) },
    {
      keys: 'shift+ArrowUp',
      label: 'Select the one before too',
      group: 'Tray',
      disabled: !current,
      run: () => stretch(-1),
    },
    {
      keys: 'f',
      label: currentMatch ? `The folder is ${currentMatch.cue.name}` : 'The folder is one cue',
      group: 'Tray',
      disabled: busy || !currentGroup,
      run: () => {
        if (!currentGroup) return
        if (currentMatch) moveFolder(currentGroup.folder, currentMatch)
        else setOpenFolder(currentGroup.folder)
      },
    },
    {
      keys: 'mod+a',
      label: 'Select all files of the tray',
      group: 'Tray',
      disabled: now.length === 0,
      run: () =>
        choose(
          now.map(({ id }) => id),
          true,
        ),
    },
  ])

  if (takes.length === 0) return null
  let room = shown
  return (
    <section aria-label="Unmatched files" aria-busy={busy}>
      <div className={`flex wrap items-center gap-2-3 ${classes.bar}`}>
        <StatusBadge kind="unmatched">{files(count)} without a cue</StatusBadge>
        {sure.length > 0 && (
          <Button variant="primary" disabled={busy} onClick={() => act({ what: 'accept', takeIds: sure })}>
            Accept {sure.length} sure {sure.length === 1 ? 'match' : 'matches'}
          </Button>
        )}
        <span className="grow" />
        {selected.length > 0 ? (
          <>
            <span className="small mid">{selected.length} selected</span>
            <Button disabled={busy} onClick={() => setMoving(!moving)} pressed={moving}>
              Move to…
            </Button>
            <Button disabled={busy} onClick={() => act({ what: 'discard', takeIds: selected })}>
              Discard
            </Button>
            <Button variant="quiet" onClick={() => setChosen(new Set())}>
              Clear
            </Button>
          </>
        ) : (
          now.length > 1 && (
            <Button
              variant="quiet"
              onClick={() =>
                choose(
                  now.map(({ id }) => id),
                  true,
                )
              }
            >
              Select all
            </Button>
          )
        )}
      </div>
      {work.error !== null && (
        <div className="p-3-inset">
          <Refusal error={work.error} />
        </div>
      )}
      {undo.error !== null && (
        <div className="p-3-inset">
          <Refusal error={undo.error} about="Undo" />
        </div>
      )}
      {moving && selected.length > 0 && (
        <div className="p-3-inset">
          <CueField
            projectId={projectId}
            label={`Cue for ${files(selected.length)}`}
            one={selected.length === 1}
            onBack={() => setMoving(false)}
            onPick={(cue, variation) =>
              act({
                what: 'move',
                moves: selected.map((id) => ({ take_id: id, cue_id: cue.id, variation })),
              })
            }
          />
        </div>
      )}
      {groups.map(({ folder, takes: all }) => {
        const drawn = all.slice(0, Math.max(0, room))
        room -= drawn.length
        if (drawn.length === 0) return null
        const ids = all.map(({ id }) => id)
        const whole = ids.every((id) => chosen.has(id))
        const match = folder === '' ? null : folderMatch(all)
        const keys = folder === currentGroup?.folder ? 'f' : undefined
        return (
          <div key={folder} role="group" aria-label={folder === '' ? 'Files' : `Folder ${folder}`}>
            {folder !== '' && (
              <div className={`flex wrap items-center gap-3 border-t ${classes.folder}`}>
                <label className={`flex items-start gap-2 min-w-0 pointer ${classes.tick}`}>
                  <input type="checkbox" checked={whole} onChange={() => choose(ids, !whole)} />
                  <span className="mono">{folder}/</span>
                </label>
                <span className="small mid grow">{files(all.length)}</span>
                {match && (
                  <Button disabled={busy} keys={keys} onClick={() => moveFolder(folder, match)}>
                    All {all.length} are {match.cue.name}
                  </Button>
                )}
                <Button
                  variant="quiet"
                  disabled={busy}
                  keys={match ? undefined : keys}
                  pressed={openFolder === folder}
                  onClick={() => setOpenFolder(openFolder === folder ? null : folder)}
                >
                  Folder is…
                </Button>
                <Button variant="quiet" disabled={busy} onClick={() => act({ what: 'discard', takeIds: ids })}>
                  Discard folder
                </Button>
              </div>
            )}
            {folder !== '' && openFolder === folder && (
              <div className="p-3-inset">
                <CueField
                  projectId={projectId}
                  label={`Cue for the folder ${folder}`}
                  one={all.length === 1}
                  onBack={() => setOpenFolder(null)}
                  onPick={({ id: cueId, name }, variation) =>
                    moveFolder(folder, {
                      cue: { id: cueId, name },
                      moves: ids.map((id) => ({ take_id: id, cue_id: cueId, variation })),
                    })
                  }
                />
              </div>
            )}
            {drawn.map((take) => (
              <UnmatchedFile
                key={take.id}
                projectId={projectId}
                take={take}
                current={current?.id === take.id}
                chosen={chosen.has(take.id)}
                player={player}
                playing={playing}
                busy={busy}
                onToggle={(ranged) => toggle(take, ranged)}
                onMove={({ id, name }, variation) =>
                  act(
                    { what: 'move', moves: [{ take_id: take.id, cue_id: id, variation }] },
                    `${take.file_name} is for ${name} and will be named for it.`,
                  )
                }
                onDiscard={() => act({ what: 'discard', takeIds: [take.id] })}
                onLater={() => setLater(new Set([...later, take.id]))}
              />
            ))}
          </div>
        )
      })}
      {now.length > shown && (
        <div className={`flex items-center gap-3 border-t ${classes.kept}`}>
          <span className="small mid">{now.length - shown} more below</span>
          <button type="button" className="link small mid" onClick={() => setShown(shown + SHOWN)}>
            Show more
          </button>
        </div>
      )}
      {kept > 0 && (
        <div className={`flex items-center gap-3 border-t ${classes.kept}`}>
          <StatusBadge kind="unmatched">{kept} skipped for now</StatusBadge>
          <button type="button" className="link small mid" onClick={() => setLater(new Set())}>
            Show {kept === 1 ? 'it' : 'them'}
          </button>
        </div>
      )}
    </section>
  )
}
