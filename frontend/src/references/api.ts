import { infiniteQueryOptions, queryOptions } from '@tanstack/react-query'

import { everyPage, get, post, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Reference = Schemas['ReferenceRead']
export type ReferenceVersion = Schemas['ReferenceVersionRead']

const page = (projectId: string, cueId: string | undefined, cursor: string | undefined) =>
  get('/v1/projects/{project_id}/references', { project_id: projectId, cue_id: cueId, cursor })

/** The references of a project, page by page. */
export const boardQuery = (projectId: string) =>
  infiniteQueryOptions({
    queryKey: queryKeys.references(projectId, 'board'),
    queryFn: ({ pageParam: cursor }) => page(projectId, undefined, cursor),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })

/** The references of one cue and of its category. */
export const cueReferencesQuery = (projectId: string, cueId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'cue', cueId),
    queryFn: async () => (await page(projectId, cueId, undefined)).items,
  })

/** The references that show words: the word list of a project. */
export const wordListQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'words'),
    queryFn: async () => {
      const pages = await everyPage((cursor) =>
        get('/v1/projects/{project_id}/references', { project_id: projectId, words: true, cursor }),
      )
      return pages.flatMap(({ items }) => items)
    },
    staleTime: 60_000,
  })

/** The address of what a version is shown or played by. */
export const partOf = (versionId: string, part: 'thumb' | 'view' | 'file'): string =>
  `/v1/reference-versions/${versionId}/${part}`

/** Record that the person opens a version: its file is sent to those of whom that is known. */
export const useOpenVersion = (projectId: string) =>
  useMutation({
    mutationFn: (versionId: string) =>
      post('/v1/reference-versions/{reference_version_id}/openings', { reference_version_id: versionId }),
    affects: [queryKeys.references(projectId, 'openings')],
  })

/** The whole text of a version that was opened. */
export const textQuery = (projectId: string, versionId: string) =>
  queryOptions({
    queryKey: queryKeys.references(projectId, 'text', versionId),
    queryFn: async () => {
      const answer = await fetch(partOf(versionId, 'file'), { headers: { Range: `bytes=0-${TEXT_BYTES - 1}` } })
      if (!answer.ok) throw new Error('The text could not be read.')
      return answer.text()
    },
    staleTime: Infinity,
  })

/** Longer texts are downloaded. */
export const TEXT_BYTES = 262_144
