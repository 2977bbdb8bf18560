import { del, post, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type SoundLibrary = components['schemas']['SoundLibraryRead']
type Sheet = components['schemas']['LibrarySheetAdd']

export const MAX_SHEET_BYTES = 24 * 2 ** 20 // the body of 32 MiB holds it in Base64

export const librariesQuery = queryById('/v1/projects/{project_id}/sound-libraries', queryKeys.soundLibraries)

export const useAddLibrary = (projectId: string) =>
  useMutation({
    mutationFn: (body: Sheet) => post('/v1/projects/{project_id}/sound-libraries', { project_id: projectId }, body),
    affects: [queryKeys.soundLibraries.all],
  })

export const useRemoveLibrary = () =>
  useMutation({
    mutationFn: (id: string) => del('/v1/sound-libraries/{library_id}', { library_id: id }),
    affects: [queryKeys.soundLibraries.all, queryKeys.sameSounds.all],
  })
