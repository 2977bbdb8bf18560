import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { get, put, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { refreshList } from '../api'

type Schemas = components['schemas']
export type OwnColumn = Schemas['ColumnRead']
export type ColumnKind = OwnColumn['kind']
export type ColumnWanted = Schemas['ColumnWanted']

/** The columns of the project's own, in order. */
export const columnsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'columns'),
    queryFn: () => get('/v1/projects/{project_id}/sound-list/columns', { project_id: projectId }),
  })

/** Set all columns at once; one that is left out is removed, and its values stay with the cues. */
export function useSetColumns(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['ColumnsSet']) =>
      put('/v1/projects/{project_id}/sound-list/columns', { project_id: projectId }, body),
    onSuccess: () => refreshList(client, projectId),
  })
}
