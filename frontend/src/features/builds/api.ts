import { useQuery, useQueryClient } from '@tanstack/react-query'

import { del, everyPage, get, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type AuditSummary = Schemas['AuditSummary']
export type AuditedSound = Schemas['AuditedSoundRead']
export type SoundInBuild = Schemas['SoundInBuild']
export type GameStates = Schemas['GameStates']
export type CueInGame = Schemas['CueInGame']
export type GameTask = Schemas['GameTaskRead']
export type ListeningPass = Schemas['ListeningPassRead']
export type ListeningNow = Schemas['ListeningNow']
export type CueToHear = Schemas['CueToHear']
export type ListeningNote = Schemas['ListeningNoteRead']
export type NoteAdd = Schemas['ListeningNoteAdd']
export type HeardAs = Schemas['HeardAs']
export type CueMark = Schemas['CueMark']

export const auditsQuery = queryById('/v1/projects/{project_id}/audits', queryKeys.audits)

export const useAudit = (projectId: string, auditId: string | undefined) =>
  useQuery({
    queryKey: queryKeys.audits(projectId, 'one', auditId),
    queryFn: () => get('/v1/audits/{audit_id}', { audit_id: auditId ?? '' }),
    enabled: auditId !== undefined,
  })

/** What drifted, or every sound of the build. */
export const useAuditedSounds = (projectId: string, auditId: string | undefined, drifted: boolean) =>
  useQuery({
    queryKey: queryKeys.audits(projectId, drifted ? 'drift' : 'sounds', auditId),
    queryFn: async () => {
      const pages = await everyPage((cursor) =>
        get('/v1/audits/{audit_id}/sounds', { audit_id: auditId ?? '', drifted, cursor }),
      )
      return pages.flatMap(({ items }) => items)
    },
    enabled: auditId !== undefined,
  })

export const useSoundHistory = (projectId: string, path: string) =>
  useQuery({
    queryKey: queryKeys.audits(projectId, 'history', path),
    queryFn: () => get('/v1/projects/{project_id}/sound-history', { project_id: projectId, path }),
  })

export const useAcceptDrift = (projectId: string, auditId: string) =>
  useChange(projectId, async ({ paths, reason }: { paths: readonly string[]; reason: string }) => {
    for (const path of paths) {
      await post('/v1/audits/{audit_id}/accepted-drifts', { audit_id: auditId }, { path, reason })
    }
  })

export const useWithdraw = (projectId: string) =>
  useChange(projectId, async (ids: readonly string[]) => {
    for (const id of ids) {
      await del('/v1/accepted-drifts/{accepted_drift_id}', { accepted_drift_id: id })
    }
  })

export const useSendBack = (projectId: string, auditId: string) =>
  useChange(projectId, async ({ paths, text }: { paths: readonly string[]; text: string }) => {
    for (const path of paths) {
      await post('/v1/audits/{audit_id}/tasks', { audit_id: auditId }, { path, text })
    }
  })

/** A change of what this feature shows, all of which is asked for again. */
function useChange<T>(projectId: string, change: (of: T) => Promise<unknown>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: change,
    onSettled: () => invalidate(client, queryKeys.audits(projectId), queryKeys.listening(projectId)),
  })
}

export const gameStatesQuery = queryById('/v1/projects/{project_id}/game-states', (projectId) =>
  queryKeys.listening(projectId, 'states'),
)

export const useMarkCue = (projectId: string) =>
  useChange(projectId, ({ cueId, mark, isSet }: { cueId: string; mark: CueMark; isSet: boolean }) =>
    put('/v1/cues/{cue_id}/game-state', { cue_id: cueId }, { mark, is_set: isSet }),
  )

export const useTasks = (projectId: string, done: boolean) =>
  useQuery({
    queryKey: queryKeys.listening(projectId, done ? 'tasks done' : 'tasks'),
    queryFn: async () => {
      const pages = await everyPage((cursor) =>
        get('/v1/projects/{project_id}/game-tasks', { project_id: projectId, done, cursor }),
      )
      return pages.flatMap(({ items }) => items)
    },
  })

export const useChangeTask = (projectId: string) =>
  useChange(projectId, ({ id, isDone }: { id: string; isDone: boolean }) =>
    put('/v1/game-tasks/{game_task_id}', { game_task_id: id }, { is_done: isDone }),
  )

export const listeningQuery = queryById('/v1/projects/{project_id}/listening-pass', (projectId) =>
  queryKeys.listening(projectId, 'pass'),
)

export const useStartPass = (projectId: string) =>
  useChange(projectId, () => post('/v1/projects/{project_id}/listening-passes', { project_id: projectId }))

export const useClosePass = (projectId: string) =>
  useChange(projectId, (passId: string) =>
    post('/v1/listening-passes/{listening_pass_id}/close', { listening_pass_id: passId }),
  )

export const sendNote = (passId: string, body: NoteAdd) =>
  post('/v1/listening-passes/{listening_pass_id}/notes', { listening_pass_id: passId }, body)

export const sendUndo = (noteId: string) =>
  del('/v1/listening-notes/{listening_note_id}', { listening_note_id: noteId })
