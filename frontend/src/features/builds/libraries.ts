import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type SoundLibrary = components['schemas']['SoundLibraryRead']
type Sheet = components['schemas']['LibrarySheetAdd']

export const MAX_SHEET_BYTES = 24 * 2 ** 20 // the body of 32 MiB holds it in Base64

export const librariesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundLibraries(projectId),
    queryFn: () => get('/v1/projects/{project_id}/sound-libraries', { project_id: projectId }),
  })

export function useAddLibrary(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Sheet) => post('/v1/projects/{project_id}/sound-libraries', { project_id: projectId }, body),
    onSuccess: () => invalidate(client, queryKeys.soundLibraries.all),
  })
}

export function useRemoveLibrary() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (id: string) => del('/v1/sound-libraries/{library_id}', { library_id: id }),
    onSuccess: () => invalidate(client, queryKeys.soundLibraries.all, queryKeys.sameSounds.all),
  })
}
