import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Credits = Schemas['ProjectCreditsRead']
export type Credit = Schemas['CreditRead']

const inProject = (projectId: string) => ({ params: { path: { project_id: projectId } } })

export const creditsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.credits(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/credits', inProject(projectId))),
  })

/** A write whose answer is the list of credits as it is then. */
function useCredits<Body>(projectId: string, send: (body: Body) => Promise<Credits>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: send,
    onSuccess: (credits) => client.setQueryData(queryKeys.credits(projectId), credits),
  })
}

export const useSaveMyCredit = (projectId: string) =>
  useCredits(projectId, (body: Schemas['CreditNameSave']) =>
    answered(api.PUT('/v1/projects/{project_id}/credits/me', { ...inProject(projectId), body })),
  )

export const useAddCredit = (projectId: string) =>
  useCredits(projectId, (body: Schemas['CreditLineAdd']) =>
    answered(api.POST('/v1/projects/{project_id}/credits', { ...inProject(projectId), body })),
  )

export function useRemoveCredit(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (lineId: string) =>
      answered(api.DELETE('/v1/credit-lines/{credit_line_id}', { params: { path: { credit_line_id: lineId } } })),
    onSettled: () => invalidate(client, queryKeys.credits(projectId)),
  })
}
