import { queryOptions, useQuery } from '@tanstack/react-query'

import { get } from './endpoint'
import { queryKeys } from './queryKeys'
import type { components } from './schema.gen'

type Schemas = components['schemas']
export type Me = Schemas['Me']
export type MyProject = Schemas['MyProject']

/** The current person, with their studios and projects. */
export const meQuery = queryOptions({
  queryKey: queryKeys.me(),
  queryFn: () => get('/v1/me'),
  staleTime: 60_000,
})

/** The current person, if signed in; the request also gives the page the token that its writes carry. */
export const visitorQuery = queryOptions({
  queryKey: queryKeys.visitor(),
  queryFn: async () => {
    const session = await get('/v1/session')
    return session.signed_in ? await get('/v1/me') : null
  },
})

/** The current person's roles in one project. */
export function useMyProject(projectId: string): MyProject | undefined {
  const { data } = useQuery(meQuery)
  return data?.projects.find(({ id }) => id === projectId)
}

/** Whether a person speaks for a side of the project: who only reviews or implements does not. */
export const speaksFor = (project: MyProject | undefined): boolean =>
  project !== undefined &&
  (project.part === 'designer' || project.is_producer || project.is_liaison || project.is_approver)

/** Whether contracts and money are between this person and another; a server may have none at all. */
export function useIsParty(projectId: string): boolean {
  const { data: me } = useQuery(meQuery)
  const project = useMyProject(projectId)
  return me?.has_contracts !== false && speaksFor(project)
}
