import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect, useMemo, useState, useSyncExternalStore } from 'react'

import { meQuery } from '@/api/me'
import { invalidate, queryKeys } from '@/api/queryKeys'

import type { HeardAs, ListeningPass, NoteAdd } from './api'
import { newNoteId, NoteQueue, type RefusedNote } from './noteQueue'

/** A note as the page shows it, whether the server has it or not. */
export interface ShownNote {
  id: string
  cueId: string
  cueName: string
  said: HeardAs
  amountDb: number | null
  text: string
  by: string
  at: string
  isMine: boolean
  isDone: boolean
  isWaiting: boolean
  /** Whether it is about a moment of a recording; it replaces no other note. */
  isMoment: boolean
}

export interface Notes {
  /** The newest first. */
  notes: readonly ShownNote[]
  waiting: number
  refused: readonly RefusedNote[]
  forgetRefused: () => void
  say: (cue: { id: string; name: string }, heardAs: HeardAs, amountDb: number | null, text: string) => void
  takeBack: (note: ShownNote) => void
}

/** Notes of a pass: those on the server, with what was said here and is still on its way. */
export function useNotes(projectId: string, listening: ListeningPass): Notes {
  const client = useQueryClient()
  const { data: me } = useQuery(meQuery)
  const personId = me?.person.id ?? ''
  const queue = useMemo(
    () => new NoteQueue(personId, projectId, () => void invalidate(client, queryKeys.listening(projectId))),
    [client, personId, projectId],
  )
  useEffect(() => {
    if (queue.getState().pending.length > 0) void queue.send()
  }, [queue])
  const { pending, refused } = useSyncExternalStore(queue.subscribe, queue.getState)
  const [sent, setSent] = useState<readonly ShownNote[]>([])
  const [undone, setUndone] = useState<ReadonlySet<string>>(new Set())
  const waitingIds = new Set(pending.flatMap((entry) => (entry.kind === 'note' ? [entry.body.note_id] : [])))
  const refusedIds = new Set(refused.map(({ body }) => body.note_id))
  const fromServer = listening.notes.map((note): ShownNote => ({
    id: note.id,
    cueId: note.cue.id,
    cueName: note.cue.name,
    said: note.said,
    amountDb: note.amount_db,
    text: note.text,
    by: note.written_by.name,
    at: note.written_at,
    isMine: note.is_mine,
    isDone: note.is_done,
    isWaiting: false,
    isMoment: note.recording !== null,
  }))
  const stored = pending.flatMap((entry): ShownNote[] =>
    entry.kind === 'note' && entry.passId === listening.id ? [shownOf(entry.body, entry.cueName)] : [],
  )
  const local = [...sent, ...stored.filter(({ id }) => !sent.some((note) => note.id === id))].filter(
    ({ id }) => !refusedIds.has(id),
  )
  const replaced = new Set(local.filter(({ isMoment }) => !isMoment).map(({ cueId }) => cueId))
  const localIds = new Set(local.map(({ id }) => id))
  const known = new Set(fromServer.map(({ id }) => id))
  const mine = local.filter(({ id, cueId, isMoment }) => {
    const newest = local.findLast((note) => note.cueId === cueId && !note.isMoment)
    return (isMoment || newest?.id === id) && !known.has(id)
  })
  const notes = [
    ...mine.map((note) => ({ ...note, isWaiting: waitingIds.has(note.id) })),
    ...fromServer.filter(
      ({ isMine, isMoment, cueId, id }) => !isMine || isMoment || !replaced.has(cueId) || localIds.has(id),
    ),
  ]
    .filter(({ id }) => !undone.has(id))
    .toSorted((a, b) => b.at.localeCompare(a.at))
  return {
    notes,
    waiting: pending.length,
    refused,
    forgetRefused: () => queue.forgetRefused(),
    say: (cue, heardAs, amountDb, text) => {
      const body: NoteAdd = {
        note_id: newNoteId(),
        cue_id: cue.id,
        said: heardAs,
        amount_db: amountDb,
        text,
        written_at: new Date().toISOString(),
      }
      setSent((before) => [...before.filter(({ cueId }) => cueId !== cue.id), shownOf(body, cue.name)])
      queue.add({ kind: 'note', passId: listening.id, body, cueName: cue.name })
    },
    takeBack: (note) => {
      setUndone((before) => new Set([...before, note.id]))
      setSent((before) => before.filter(({ id }) => id !== note.id))
      queue.add({ kind: 'undo', id: note.id })
    },
  }
}

const shownOf = (body: NoteAdd, cueName: string): ShownNote => ({
  id: body.note_id,
  cueId: body.cue_id,
  cueName,
  said: body.said,
  amountDb: body.amount_db ?? null,
  text: body.text,
  by: 'you',
  at: body.written_at ?? '',
  isMine: true,
  isDone: false,
  isWaiting: true,
  isMoment: body.recording != null,
})
