import { queryOptions } from '@tanstack/react-query'

import { answered, api } from './client'
import { queryKeys } from './queryKeys'

const inProject = (projectId: string) => ({ params: { path: { project_id: projectId } } })

export const projectQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.project(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}', inProject(projectId))),
  })

/** The people of a studio, for those of them who run a project. */
export const studioPeopleQuery = (studioId: string) =>
  queryOptions({
    queryKey: queryKeys.studioPeople(studioId),
    queryFn: () => answered(api.GET('/v1/studios/{studio_id}/people', { params: { path: { studio_id: studioId } } })),
  })

/** The categories of the sound list, with the number of their cues. */
export const categoriesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.categories(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/categories', inProject(projectId))),
  })

/** What the brief names and no cue is for. */
export const coverageQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.coverage(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/sound-list/coverage', inProject(projectId))),
  })

/** Every contract of a project that the person may see. */
export const contractsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.contracts(projectId),
    queryFn: () => answered(api.GET('/v1/projects/{project_id}/contracts', inProject(projectId))),
  })

export const contractQuery = (contractId: string) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId),
    queryFn: () => answered(api.GET('/v1/contracts/{contract_id}', { params: { path: { contract_id: contractId } } })),
  })
