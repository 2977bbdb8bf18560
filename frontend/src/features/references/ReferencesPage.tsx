import { useInfiniteQuery, useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useCallback, useEffect, useEffectEvent, useMemo, useRef, useState } from 'react'

import { meQuery, useMyProject } from '@/api/me'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { boardQuery, type Reference, ReferenceDialog, ReferenceTile, titleOf } from '@/references'
import { Count } from '@/ui/Count'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { filesOfField, type Picked, usePageDrop } from '@/uploads'
import { ShowMore } from '@/ui/ShowMore'

import { AddCard } from './AddCard'
import classes from './Board.module.css'
import { EditDialog } from './EditDialog'
import { groupsOf, type Pin } from './pins'
import { uploadsOf } from './referenceUploads'
import { UploadLines } from './UploadLines'

const GROUP = 'References'
const KINDS = { project: '', category: 'category', cue: 'cue' }

/** The board: what shows how the project, its categories and its cues are meant. */
export function ReferencesPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { cue } = useSearch({ from: '/shell/projects/$projectId/references' })
  const board = useInfiniteQuery(boardQuery(projectId))
  const project = useMyProject(projectId)
  const { data: me } = useQuery(meQuery)
  const mayAdd = (project?.is_producer || project?.is_liaison || project?.is_approver) ?? false
  useTitle('References')
  const references = useMemo(() => board.data?.pages.flatMap(({ items }) => items), [board.data])
  const [shown, setShown] = useState<Reference | null>(null)
  const [edited, setEdited] = useState<Reference | null>(null)
  useHotkeys([
    { keys: 'j', label: 'Next reference', group: GROUP, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous reference', group: GROUP, run: () => step(-1), repeats: true },
  ])
  const uploads = useUploadsOf(projectId, mayAdd ? me?.person.id : undefined)
  return (
    <div className={`page stack content-start ${classes.page}`} aria-busy={board.isPending}>
      <header className="row wrap">
        <h1>References</h1>
        {references && references.length > 0 && (
          <Count of={board.hasNextPage ? `${references.length}+` : references.length} />
        )}
      </header>
      <Refusal error={board.error} />
      {mayAdd && uploads && <Adding key={cue} projectId={projectId} cueId={cue} uploads={uploads} />}
      {references?.length === 0 && (
        <EmptyState head="No references yet">
          {mayAdd
            ? 'Put here what words do not say: concept art, a clip of the game, a sound that comes near, a page of the story. Pin it to a cue where it is meant for one sound.'
            : 'The team has not added any yet. What shows how a sound is meant will be here and beside its cue.'}
        </EmptyState>
      )}
      {groupsOf(references ?? []).map(({ key, name, kind, references: own }) => (
        <section key={key} aria-label={name} className="grid gap-3">
          <header className={`row wrap ${classes.groupHead}`}>
            <h2>{name}</h2>
            {KINDS[kind] && <span className="small dim">{KINDS[kind]}</span>}
            <Count of={own.length} />
          </header>
          <div className={`grid gap-4 ${classes.grid}`}>
            {own.map((reference) => (
              <ReferenceTile key={reference.id} reference={reference} onShow={setShown}>
                <p className="small dim flex wrap items-center gap-0-2">
                  {reference.version.number > 1 && `version ${reference.version.number}, `}
                  from {reference.version.added_by.name}
                  {reference.may_change && reference.version.kind === 'video' && (
                    <Link
                      className="link small"
                      to="/projects/$projectId/references/$referenceId/spotting"
                      params={{ projectId, referenceId: reference.id }}
                    >
                      Spot <span className="visually-hidden">{titleOf(reference)}</span>
                    </Link>
                  )}
                  {reference.may_change && (
                    <button type="button" className="link small" onClick={() => setEdited(reference)}>
                      Edit <span className="visually-hidden">{reference.caption || reference.version.file_name}</span>
                    </button>
                  )}
                </p>
              </ReferenceTile>
            ))}
          </div>
        </section>
      ))}
      <ShowMore list={board} />
      <ReferenceDialog reference={shown} onClose={() => setShown(null)} />
      <EditDialog
        reference={edited}
        onClose={() => setEdited(null)}
        onNewVersion={({ id }, files) => void uploads?.add(filesOfField(files).slice(0, 1), { referenceId: id })}
      />
    </div>
  )
}

type Uploads = ReturnType<typeof uploadsOf>

function useUploadsOf(projectId: string, personId: string | undefined): Uploads | null {
  const client = useQueryClient()
  return useMemo(
    () => (personId === undefined ? null : uploadsOf(client, projectId, personId)),
    [client, projectId, personId],
  )
}

function Adding({ projectId, cueId, uploads }: { projectId: string; cueId: string | undefined; uploads: Uploads }) {
  const [pin, setPin] = useState<Pin>(cueId === undefined ? '' : `cue:${cueId}`)
  const fileField = useRef<HTMLInputElement>(null)
  const add = useCallback((picked: Picked[]) => void uploads.add(picked, { pin }), [uploads, pin])
  const isOver = usePageDrop(add)
  const paste = useEffectEvent((event: ClipboardEvent) => {
    const isTyping = event.target instanceof HTMLElement && event.target.closest('input, textarea, select') !== null
    const files = event.clipboardData?.files
    if (isTyping || !event.clipboardData) return
    if (files && files.length > 0) {
      event.preventDefault()
      add(filesOfField(files))
    } else if (event.clipboardData.getData('text').trim().startsWith('https://')) {
      document.getElementById('reference-link')?.focus() // the browser pastes into what has the focus
    }
  })
  useEffect(() => {
    const listen = (event: ClipboardEvent) => paste(event)
    window.addEventListener('paste', listen)
    return () => window.removeEventListener('paste', listen)
  }, [])
  useHotkeys([{ keys: 'n', label: 'Add files', group: GROUP, run: () => fileField.current?.click() }])
  return (
    <>
      <AddCard
        projectId={projectId}
        pin={pin}
        onPin={setPin}
        fileField={fileField}
        onFiles={(files) => add(filesOfField(files))}
      />
      {isOver && <p className={`rounded ${classes.over}`}>Drop the files to add them to the board.</p>}
      <UploadLines queue={uploads.queue} />
    </>
  )
}

/** Move the focus from tile to tile. */
function step(by: 1 | -1): void {
  const tiles = [...document.querySelectorAll<HTMLElement>('[data-reference]')]
  const at = tiles.findIndex((tile) => tile.contains(document.activeElement))
  const next = tiles[at < 0 ? (by > 0 ? 0 : tiles.length - 1) : at + by]
  next?.querySelector<HTMLElement>('button, a, audio, video')?.focus()
}
