import { useQueryClient } from '@tanstack/react-query'

import { put, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

import { refreshList } from '../api'

type Schemas = components['schemas']
export type OwnColumn = Schemas['ColumnRead']
export type ColumnKind = OwnColumn['kind']
export type ColumnWanted = Schemas['ColumnWanted']

/** The columns of the project's own, in order. */
export const columnsQuery = queryById('/v1/projects/{project_id}/sound-list/columns', (projectId) =>
  queryKeys.soundList(projectId, 'columns'),
)

/** Set all columns at once; one that is left out is removed, and its values stay with the cues. */
export function useSetColumns(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Schemas['ColumnsSet']) =>
      put('/v1/projects/{project_id}/sound-list/columns', { project_id: projectId }, body),
    onSuccess: () => refreshList(client, projectId),
  })
}
