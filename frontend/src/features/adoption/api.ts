import { type QueryClient, useQueryClient } from '@tanstack/react-query'

import { post, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type FolderAsk = Schemas['FolderAsk']
export type ShippedFile = Schemas['ShippedFileIn']
export type Plan = Schemas['AdoptionPlanRead']
export type Adoption = Schemas['AdoptionRead']
export type Progress = Schemas['AdoptionProgress']

const POLL_MS = 3_000

/** What adopting a folder would do; nothing is written. */
export const planFolder = (projectId: string, body: FolderAsk) =>
  post('/v1/projects/{project_id}/adoption-plan', { project_id: projectId }, body)

export const openAdoption = (projectId: string, body: FolderAsk) =>
  post('/v1/projects/{project_id}/adoptions', { project_id: projectId }, body)

export const adoptFolder = (adoptionId: string) =>
  post('/v1/adoptions/{adoption_id}/adopt', { adoption_id: adoptionId })

/** The adoptions of a project, the newest first. */
export const adoptionsQuery = queryById('/v1/projects/{project_id}/adoptions', queryKeys.adoptions)

/** A folder that was sent by the command line: its plan, and what is still to be uploaded. */
export const sentPlanQuery = queryById('/v1/adoptions/{adoption_id}/plan', (adoptionId) =>
  queryKeys.adoption(adoptionId, 'plan'),
)

/** How far the checks are; asked for again until every adopted sound is checked and rendered. */
export const progressQuery = queryById('/v1/adoptions/{adoption_id}', queryKeys.adoption, {
  refetchInterval: ({ state: { data } }) =>
    data && data.adopted_at !== null && data.undone_at === null && data.rendered < data.takes ? POLL_MS : false,
})

/** Refetch what an adoption, or its undo, changes on any page. */
export const refreshAdopted = (client: QueryClient, projectId: string) =>
  invalidate(
    client,
    queryKeys.adoptions(projectId),
    queryKeys.adoption.all,
    queryKeys.soundList(projectId),
    queryKeys.overview(projectId),
    queryKeys.packs(projectId),
  )

export function useUndoAdoption(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (adoptionId: string) => post('/v1/adoptions/{adoption_id}/undo', { adoption_id: adoptionId }),
    onSuccess: () => refreshAdopted(client, projectId),
  })
}
