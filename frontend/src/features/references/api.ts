import { queryOptions, useInfiniteQuery } from '@tanstack/react-query'

import { del, get, patch, post, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Opening = Schemas['ReferenceOpeningRead']
export type ReferenceAdd = Partial<Schemas['ReferenceAdd']>
export type ReferenceChange = Partial<Schemas['ReferenceChange']>

export const versionsQuery = (projectId: string, referenceId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'versions', referenceId),
    queryFn: () => get('/v1/references/{reference_id}/versions', { reference_id: referenceId }),
  })

/** Who opened what: of the whole project, or of one reference. */
export const useOpenings = (projectId: string, referenceId?: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.references(projectId, 'openings', referenceId),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/reference-openings', { project_id: projectId, reference: referenceId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

export const addReference = (projectId: string, body: ReferenceAdd) =>
  post(
    '/v1/projects/{project_id}/references',
    { project_id: projectId },
    { caption: '', terms: '', words: '', ...body },
  )

export const addVersion = (referenceId: string, body: { upload_id: string } | { url: string }) =>
  post('/v1/references/{reference_id}/versions', { reference_id: referenceId }, body)

export const useAddLink = (projectId: string) =>
  useMutation({
    mutationFn: (body: ReferenceAdd) => addReference(projectId, body),
    affects: [queryKeys.references(projectId)],
  })

export const useChangeReference = (projectId: string, referenceId: string) =>
  useMutation({
    mutationFn: (body: ReferenceChange) =>
      patch('/v1/references/{reference_id}', { reference_id: referenceId }, body as Schemas['ReferenceChange']),
    affects: [queryKeys.references(projectId)],
  })

export const useRemoveReference = (projectId: string, referenceId: string) =>
  useMutation({
    mutationFn: () => del('/v1/references/{reference_id}', { reference_id: referenceId }),
    affects: [queryKeys.references(projectId)],
  })
