import { queryOptions } from '@tanstack/react-query'

import { del, get, leaveSession, post, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { forgetDrafts } from '@/app/drafts'

export type Erasure = components['schemas']['ErasureRead']

/** What is to be erased: the account of who is signed in, or a project or studio by its id. */
export type Subject = { kind: 'account' } | { kind: 'project' | 'studio'; id: string }

const idOf = (subject: Subject) => (subject.kind === 'account' ? '' : subject.id)

function read(subject: Subject): Promise<Erasure> {
  if (subject.kind === 'account') return get('/v1/me/erasure')
  if (subject.kind === 'project') return get('/v1/projects/{project_id}/erasure', { project_id: subject.id })
  return get('/v1/studios/{studio_id}/erasure', { studio_id: subject.id })
}

export const erasureQuery = (subject: Subject) =>
  queryOptions({ queryKey: queryKeys.erasure(subject.kind, idOf(subject)), queryFn: () => read(subject) })

/** Erase the account, and leave: nothing of it may be shown any more. */
export const useEraseAccount = () =>
  useMutation({
    mutationFn: (confirmation: string) => post('/v1/me/erasure', {}, { confirmation }),
    onSuccess: () => {
      leaveSession()
      forgetDrafts()
    },
  })

export const useRequestErasure = (subject: Exclude<Subject, { kind: 'account' }>) =>
  useMutation({
    mutationFn: (confirmation: string) =>
      subject.kind === 'project'
        ? post('/v1/projects/{project_id}/erasure', { project_id: subject.id }, { confirmation })
        : post('/v1/studios/{studio_id}/erasure', { studio_id: subject.id }, { confirmation }),
    affects: [queryKeys.erasure(subject.kind, subject.id)],
  })

export const useCancelErasure = (subject: Exclude<Subject, { kind: 'account' }>) =>
  useMutation({
    mutationFn: () =>
      subject.kind === 'project'
        ? del('/v1/projects/{project_id}/erasure', { project_id: subject.id })
        : del('/v1/studios/{studio_id}/erasure', { studio_id: subject.id }),
    affects: [queryKeys.erasure(subject.kind, subject.id)],
  })
