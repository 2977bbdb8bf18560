import { queryOptions, useInfiniteQuery, useQueryClient } from '@tanstack/react-query'

import { answered, api, everyPage, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Opening = Schemas['ReferenceOpeningRead']
export type ReferenceAdd = Partial<Schemas['ReferenceAdd']>
export type ReferenceChange = Partial<Schemas['ReferenceChange']>

/** The cues that a reference can be pinned to. */
export const cuesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'to pin to'),
    queryFn: async () => {
      const pages = await everyPage((cursor) =>
        answered(
          api.GET('/v1/projects/{project_id}/sound-list', {
            params: { path: { project_id: projectId }, query: { cursor, limit: 500 } },
          }),
        ),
      )
      return pages
        .flatMap(({ cues }) => cues)
        .filter(({ state }) => state !== 'cut')
        .map(({ id, label, name, category }) => ({ id, label, name, category }))
    },
  })

export const versionsQuery = (projectId: string, referenceId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'versions', referenceId),
    queryFn: () =>
      answered(api.GET('/v1/references/{reference_id}/versions', { params: { path: { reference_id: referenceId } } })),
  })

/** Who opened what: of the whole project, or of one reference. */
export const useOpenings = (projectId: string, referenceId?: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.references(projectId, 'openings', referenceId),
    queryFn: ({ pageParam: cursor }) =>
      answered(
        api.GET('/v1/projects/{project_id}/reference-openings', {
          params: { path: { project_id: projectId }, query: { reference: referenceId, cursor } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

export const addReference = (projectId: string, body: ReferenceAdd) =>
  answered(
    api.POST('/v1/projects/{project_id}/references', {
      params: { path: { project_id: projectId } },
      body: { caption: '', terms: '', ...body },
    }),
  )

export const addVersion = (referenceId: string, body: { upload_id: string } | { url: string }) =>
  answered(
    api.POST('/v1/references/{reference_id}/versions', { params: { path: { reference_id: referenceId } }, body }),
  )

export function useAddLink(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: ReferenceAdd) => addReference(projectId, body),
    onSuccess: () => invalidate(client, queryKeys.references(projectId)),
  })
}

export function useChangeReference(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: ReferenceChange) =>
      answered(
        api.PATCH('/v1/references/{reference_id}', {
          params: { path: { reference_id: referenceId } },
          body: body as Schemas['ReferenceChange'],
        }),
      ),
    onSuccess: () => invalidate(client, queryKeys.references(projectId)),
  })
}

export function useRemoveReference(projectId: string, referenceId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () =>
      answered(api.DELETE('/v1/references/{reference_id}', { params: { path: { reference_id: referenceId } } })),
    onSuccess: () => invalidate(client, queryKeys.references(projectId)),
  })
}
