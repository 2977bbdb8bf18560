import { queryOptions } from '@tanstack/react-query'

import { get, queryById } from './endpoint'
import { queryKeys } from './queryKeys'

export const projectQuery = queryById('/v1/projects/{project_id}', queryKeys.project)

/** The people of a studio, for those of them who run a project. */
export const studioPeopleQuery = queryById('/v1/studios/{studio_id}/people', queryKeys.studioPeople)

/** Kinds of game that a list can be started from: part of the product, so they stay as long as the page is open. */
export const kitsQuery = queryOptions({
  queryKey: queryKeys.kits(),
  queryFn: () => get('/v1/kits'),
  staleTime: Infinity,
})

/** The categories of the sound list, with the number of their cues. */
export const categoriesQuery = queryById('/v1/projects/{project_id}/categories', queryKeys.categories)

/** What the brief names and no cue is for. */
export const coverageQuery = queryById('/v1/projects/{project_id}/sound-list/coverage', queryKeys.coverage)

/** Every contract of a project that the person may see. */
export const contractsQuery = queryById('/v1/projects/{project_id}/contracts', queryKeys.contracts)

export const contractQuery = queryById('/v1/contracts/{contract_id}', queryKeys.contract)

export const overviewQuery = queryById('/v1/projects/{project_id}/overview', queryKeys.overview)

export const specQuery = queryById('/v1/projects/{project_id}/spec', queryKeys.spec)

/** The playlists of a project that the current person hears. */
export const playlistsQuery = queryById('/v1/projects/{project_id}/playlists', queryKeys.playlists)

export const ciQuery = queryById('/v1/projects/{project_id}/ci', queryKeys.ci)
