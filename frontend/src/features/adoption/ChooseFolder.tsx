import { useQueryClient } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import { type ReactNode, useCallback, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { filesOfField, type Picked, useLeaveWarning, usePageDrop, type UploadQueue, useUploads } from '@/uploads'

import { adoptFolder, openAdoption, type Plan, planFolder, refreshAdopted } from './api'
import classes from './Adopt.module.css'
import { canHash, type Folder, MOST_FILES, readFolder, soundsOf } from './folder'
import { folderQueue, sendAll } from './folderUploads'
import { type GameProject, packProject, projectIn, ProjectTooLarge } from './gameProject'
import { PlanCard } from './PlanCard'

type Stage =
  | { at: 'choose' }
  | { at: 'read'; done: number; of: number }
  | { at: 'planned'; folder: Folder; project: GameProject | null; plan: Plan }
  | { at: 'sending'; queue: UploadQueue; of: number }
  | { at: 'adopting' }

class Refused extends Error {}

const messageOf = (error: unknown): { detail: string; fix?: string } =>
  error instanceof ApiProblem || error instanceof Refused || error instanceof ProjectTooLarge
    ? { detail: error.message, fix: error instanceof ApiProblem ? error.fix : undefined }
    : { detail: 'A file could not be read from your disk.', fix: 'Choose the folder again.' }

/** A folder is chosen, planned, and after a look at the plan sent and adopted. */
export function ChooseFolder({ projectId }: { projectId: string }): ReactNode {
  const client = useQueryClient()
  const navigate = useNavigate()
  const [stage, setStage] = useState<Stage>({ at: 'choose' })
  const [problem, setProblem] = useState<{ detail: string; fix?: string } | null>(null)
  const field = useRef<HTMLInputElement>(null)
  const projectField = useRef<HTMLInputElement>(null)

  const attempt = async (act: () => Promise<void>, before: Stage) => {
    setProblem(null)
    try {
      await act()
    } catch (error) {
      setProblem(messageOf(error))
      setStage(before)
    }
  }
  const planned = useCallback(
    (folder: Folder, project: GameProject | null) =>
      planFolder(projectId, { folder: folder.name, files: folder.files, project }),
    [projectId],
  )
  const take = useCallback(
    (picked: Picked[], isProject = false) =>
      void attempt(
        async () => {
          if (!canHash()) throw new Refused('This page is not secure: open it by https, or use soundlist adopt.')
          const sounds = soundsOf(picked)
          const gameProject = projectIn(picked)
          const sent = gameProject ? await packProject(picked, gameProject) : null
          if (sent !== null && stage.at === 'planned' && (sounds.length === 0 || isProject)) {
            setStage({ ...stage, project: sent, plan: await planned(stage.folder, sent) })
            return
          }
          if (isProject || (sounds.length === 0 && sent !== null))
            throw new Refused(
              sent === null
                ? 'There is no project in what you chose: no .wproj, .fspro, project.godot or Unity project.'
                : 'This is the game’s project. Choose the folder of the sounds first.',
            )
          if (sounds.length === 0) throw new Refused('There is no sound file in what you chose.')
          if (sounds.length > MOST_FILES)
            throw new Refused(
              `There are ${sounds.length} sounds. Adopt folders with at most ${MOST_FILES}, one by one.`,
            )
          setStage({ at: 'read', done: 0, of: sounds.length })
          const folder = await readFolder(sounds, (done) => setStage({ at: 'read', done, of: sounds.length }))
          const project = sent ?? (stage.at === 'planned' ? stage.project : null)
          setStage({ at: 'planned', folder, project, plan: await planned(folder, project) })
        },
        stage.at === 'planned' ? stage : { at: 'choose' },
      ),
    [planned, stage],
  )
  const isOver = usePageDrop((picked) => (stage.at === 'choose' || stage.at === 'planned') && take(picked))
  const adopt = (before: Stage & { at: 'planned' }) =>
    void attempt(async () => {
      const { folder, project } = before
      const opened = await openAdoption(projectId, { folder: folder.name, files: folder.files, project })
      const queue = folderQueue(opened.id)
      setStage({ at: 'sending', queue, of: opened.missing.length })
      const files = opened.missing.flatMap((path) => {
        const file = folder.sources.get(path)
        return file ? [{ path, file }] : []
      })
      const [failed] = await sendAll(queue, files)
      if (failed)
        throw new Refused(`${failed.path} was not sent: ${failed.reason ?? 'it was stopped'} Nothing was adopted.`)
      setStage({ at: 'adopting' })
      const adoption = await adoptFolder(opened.id)
      await refreshAdopted(client, projectId)
      showToast(`${plural(adoption.cues, 'cue')} adopted with ${plural(adoption.takes, 'take')}.`)
      await navigate({
        to: '/projects/$projectId/sound-list/adopt',
        params: { projectId },
        search: { adoption: opened.id },
      })
    }, before)
  useHotkeys([
    {
      keys: 'o',
      label: 'Choose a folder',
      group: 'Adopt',
      run: () => field.current?.click(),
      disabled: stage.at !== 'choose' && stage.at !== 'planned',
    },
  ])
  return (
    <>
      {problem && <ErrorBanner {...problem} />}
      {(stage.at === 'choose' || stage.at === 'planned') && (
        <Card aria-labelledby="choose">
          <CardHead id="choose" title="The game’s sounds" note="Drop the folder anywhere on this page" />
          <div className={`flex wrap items-center gap-2-3 ${classes.choose}`} data-over={isOver || undefined}>
            <Button
              variant={stage.at === 'choose' ? 'primary' : 'plain'}
              keys="o"
              onClick={() => field.current?.click()}
            >
              {stage.at === 'choose' ? 'Choose a folder' : 'Choose another folder'}
            </Button>
            {stage.at === 'planned' && (
              <Button onClick={() => projectField.current?.click()}>
                {stage.project === null ? 'Add the game’s project' : 'Choose another project'}
              </Button>
            )}
            <span className="mid">
              {stage.at === 'choose'
                ? 'You see what happens to each file before anything is sent.'
                : 'With a project of Wwise, FMOD Studio, Unity or Godot, the plan has its sets, loops, events and levels. For Unreal, drop the JSON of export_sounds.py.'}
            </span>
            <input
              ref={projectField}
              type="file"
              multiple
              hidden
              aria-label="Project of the game"
              {...{ webkitdirectory: '' }}
              onChange={(event) => {
                take(filesOfField(event.currentTarget.files ?? []), true)
                event.currentTarget.value = ''
              }}
            />
            <input
              ref={field}
              type="file"
              multiple
              hidden
              aria-label="Folder"
              {...{ webkitdirectory: '' }}
              onChange={(event) => {
                take(filesOfField(event.currentTarget.files ?? []))
                event.currentTarget.value = ''
              }}
            />
          </div>
        </Card>
      )}
      {stage.at === 'read' && <Going says={`Reading ${stage.done} of ${plural(stage.of, 'file')}`} {...stage} />}
      {stage.at === 'planned' && (
        <PlanCard plan={stage.plan} action={`Adopt ${plural(stage.plan.files, 'file')}`} onAdopt={() => adopt(stage)} />
      )}
      {stage.at === 'sending' && <Sending queue={stage.queue} of={stage.of} />}
      {stage.at === 'adopting' && <Going says="Adopting the folder" done={1} of={1} />}
    </>
  )
}

function Sending({ queue, of }: { queue: UploadQueue; of: number }) {
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  const done = uploads.filter(({ state }) => state === 'finished').length
  const isLost = uploads.some(({ state }) => state === 'line_lost')
  return (
    <Going
      says={`Sending ${done} of ${plural(of, 'file')}. Stay on this page.`}
      note={isLost ? 'Connection lost. The upload resumes automatically.' : undefined}
      done={done}
      of={of}
    />
  )
}

function Going({ says, note, done, of }: { says: string; note?: string; done: number; of: number }) {
  return (
    <div className="grid gap-2" role="status">
      <p>{says}</p>
      <Meter label={says} whole={Math.max(1, of)} parts={[{ value: done }]} />
      {note && <p className="small dim">{note}</p>}
    </div>
  )
}
