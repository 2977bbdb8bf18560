import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import type { Reference } from '@/references'

type SpottedMark = components['schemas']['SpottedMark']

/** One reference of the board. */
export const clipQuery = (projectId: string, referenceId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'clip', referenceId),
    queryFn: async (): Promise<Reference | null> => {
      let cursor: string | undefined
      do {
        const page = await get('/v1/projects/{project_id}/references', { project_id: projectId, cursor })
        const reference = page.items.find(({ id }) => id === referenceId)
        if (reference) return reference
        cursor = page.next ?? undefined
      } while (cursor !== undefined)
      return null
    },
  })

/** The category that the words of a name speak of; empty for none. */
export const guessQuery = (projectId: string, name: string) =>
  queryOptions({
    queryKey: queryKeys.categories(projectId, name),
    queryFn: async () =>
      (await get('/v1/projects/{project_id}/category-guess', { project_id: projectId, name })).category,
    staleTime: 60_000,
  })

export function useAddSpottedCues(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (marks: SpottedMark[]) =>
      post('/v1/references/{reference_id}/cues', { reference_id: referenceId }, { marks }),
    onSuccess: () => refreshBoth(client, projectId),
  })
}

export function useUndoSpottedCues(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (cueIds: string[]) =>
      post('/v1/references/{reference_id}/cues/undo', { reference_id: referenceId }, { cue_ids: cueIds }),
    onSuccess: () => refreshBoth(client, projectId),
  })
}

const refreshBoth = (client: ReturnType<typeof useQueryClient>, projectId: string) =>
  invalidate(
    client,
    queryKeys.references(projectId),
    queryKeys.soundList(projectId),
    queryKeys.categories(projectId),
    queryKeys.coverage(projectId),
    queryKeys.progress(projectId),
    queryKeys.today.all,
    queryKeys.overview.all,
  )
