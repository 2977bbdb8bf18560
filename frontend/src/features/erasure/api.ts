import { queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, leaveSession, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { forgetDrafts } from '@/app/drafts'

export type Erasure = components['schemas']['ErasureRead']

/** What is to be erased: the account of who is signed in, or a project or studio by its id. */
export type Subject = { kind: 'account' } | { kind: 'project' | 'studio'; id: string }

const ofProject = (id: string) => ({ params: { path: { project_id: id } } })
const ofStudio = (id: string) => ({ params: { path: { studio_id: id } } })
const idOf = (subject: Subject) => (subject.kind === 'account' ? '' : subject.id)

function read(subject: Subject): Promise<Erasure> {
  if (subject.kind === 'account') return answered(api.GET('/v1/me/erasure'))
  if (subject.kind === 'project') return answered(api.GET('/v1/projects/{project_id}/erasure', ofProject(subject.id)))
  return answered(api.GET('/v1/studios/{studio_id}/erasure', ofStudio(subject.id)))
}

export const erasureQuery = (subject: Subject) =>
  queryOptions({ queryKey: queryKeys.erasure(subject.kind, idOf(subject)), queryFn: () => read(subject) })

/** Erase the account, and leave: nothing of it may be shown any more. */
export function useEraseAccount() {
  return useMutation({
    mutationFn: (confirmation: string) => answered(api.POST('/v1/me/erasure', { body: { confirmation } })),
    onSuccess: () => {
      leaveSession()
      forgetDrafts()
    },
  })
}

export function useRequestErasure(subject: Exclude<Subject, { kind: 'account' }>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (confirmation: string) =>
      subject.kind === 'project'
        ? answered(api.POST('/v1/projects/{project_id}/erasure', { ...ofProject(subject.id), body: { confirmation } }))
        : answered(api.POST('/v1/studios/{studio_id}/erasure', { ...ofStudio(subject.id), body: { confirmation } })),
    onSuccess: () => invalidate(client, queryKeys.erasure(subject.kind, subject.id)),
  })
}

export function useCancelErasure(subject: Exclude<Subject, { kind: 'account' }>) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: () =>
      subject.kind === 'project'
        ? answered(api.DELETE('/v1/projects/{project_id}/erasure', ofProject(subject.id)))
        : answered(api.DELETE('/v1/studios/{studio_id}/erasure', ofStudio(subject.id))),
    onSuccess: () => invalidate(client, queryKeys.erasure(subject.kind, subject.id)),
  })
}
