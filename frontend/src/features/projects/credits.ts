import { useQueryClient } from '@tanstack/react-query'

import { del, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Credits = Schemas['ProjectCreditsRead']
export type Credit = Schemas['CreditRead']

export const creditsQuery = queryById('/v1/projects/{project_id}/credits', queryKeys.credits)

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
    put('/v1/projects/{project_id}/credits/me', { project_id: projectId }, body),
  )

export const useAddCredit = (projectId: string) =>
  useCredits(projectId, (body: Schemas['CreditLineAdd']) =>
    post('/v1/projects/{project_id}/credits', { project_id: projectId }, body),
  )

export function useRemoveCredit(projectId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (lineId: string) => del('/v1/credit-lines/{credit_line_id}', { credit_line_id: lineId }),
    onSettled: () => invalidate(client, queryKeys.credits(projectId)),
  })
}
