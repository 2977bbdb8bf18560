import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
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
        const page = await answered(
          api.GET('/v1/projects/{project_id}/references', {
            params: { path: { project_id: projectId }, query: { cursor } },
          }),
        )
        const found = page.items.find(({ id }) => id === referenceId)
        if (found) return found
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
      (
        await answered(
          api.GET('/v1/projects/{project_id}/category-guess', {
            params: { path: { project_id: projectId }, query: { name } },
          }),
        )
      ).category,
    staleTime: 60_000,
  })

const ofReference = (referenceId: string) => ({ params: { path: { reference_id: referenceId } } })

export function useAddSpottedCues(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (marks: SpottedMark[]) =>
      answered(api.POST('/v1/references/{reference_id}/cues', { ...ofReference(referenceId), body: { marks } })),
    onSuccess: () => refreshBoth(client, projectId),
  })
}

export function useUndoSpottedCues(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (cueIds: string[]) =>
      answered(
        api.POST('/v1/references/{reference_id}/cues/undo', {
          ...ofReference(referenceId),
          body: { cue_ids: cueIds },
        }),
      ),
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
