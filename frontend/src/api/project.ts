import { queryOptions } from '@tanstack/react-query'

import { get } from './endpoint'
import { queryKeys } from './queryKeys'

export const projectQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.project(projectId),
    queryFn: () => get('/v1/projects/{project_id}', { project_id: projectId }),
  })

/** The people of a studio, for those of them who run a project. */
export const studioPeopleQuery = (studioId: string) =>
  queryOptions({
    queryKey: queryKeys.studioPeople(studioId),
    queryFn: () => get('/v1/studios/{studio_id}/people', { studio_id: studioId }),
  })

/** The categories of the sound list, with the number of their cues. */
export const categoriesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.categories(projectId),
    queryFn: () => get('/v1/projects/{project_id}/categories', { project_id: projectId }),
  })

/** What the brief names and no cue is for. */
export const coverageQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.coverage(projectId),
    queryFn: () => get('/v1/projects/{project_id}/sound-list/coverage', { project_id: projectId }),
  })

/** Every contract of a project that the person may see. */
export const contractsQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.contracts(projectId),
    queryFn: () => get('/v1/projects/{project_id}/contracts', { project_id: projectId }),
  })

export const contractQuery = (contractId: string) =>
  queryOptions({
    queryKey: queryKeys.contract(contractId),
    queryFn: () => get('/v1/contracts/{contract_id}', { contract_id: contractId }),
  })
