import { keepPreviousData, queryOptions, useQueryClient } from '@tanstack/react-query'

import { del, get, patch, post, put, queryById, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

type Schemas = components['schemas']
export type Scene = Schemas['SceneRead']
export type SceneLane = Schemas['SceneLaneRead']
export type SceneClip = Schemas['ClipRead']
export type Masking = Schemas['MaskingRead']
export type MaskedBand = Schemas['MaskedBand']
export type BedSource = Schemas['BedSource']
export type BedRole = Schemas['BedRole']
export type Comparison = Schemas['SoundComparisonRead']

const AGAIN_MS = 1_000

/** What sounds with a version; asked again until all of it is measured. */
export const sceneQuery = (takeId: string) =>
  queryOptions({
    queryKey: queryKeys.scene(takeId),
    queryFn: () => post('/v1/takes/{take_id}/scene', { take_id: takeId }),
    refetchInterval: ({ state }) => (state.data?.is_ready === false ? AGAIN_MS : false),
    placeholderData: keepPreviousData,
  })

/** Which bands of a version are heard among lanes at these levels, each as "music:-12". */
export const maskingQuery = (takeId: string, lanes: readonly string[], isReady: boolean) =>
  queryOptions({
    queryKey: queryKeys.masking(takeId, lanes.join(' ')),
    queryFn: () => get('/v1/takes/{take_id}/masking', { take_id: takeId, lane: [...lanes] }),
    enabled: isReady,
    placeholderData: keepPreviousData,
  })

export const bedSourcesQuery = queryById('/v1/projects/{project_id}/bed-sources', queryKeys.bedSources)

/** Put, change and take away what plays under the sounds of a project or of a category. */
export function useBeds(projectId: string) {
  const client = useQueryClient()
  const onSettled = () => invalidate(client, queryKeys.scene.all)
  const set = useMutation({
    mutationFn: (bed: Schemas['BedSet']) => put('/v1/projects/{project_id}/beds', { project_id: projectId }, bed),
    onSettled,
  })
  const change = useMutation({
    mutationFn: ({ id, ...body }: { id: string } & Schemas['BedChange']) =>
      patch('/v1/beds/{bed_id}', { bed_id: id }, body),
    onSettled,
  })
  const remove = useMutation({
    mutationFn: (id: string) => del('/v1/beds/{bed_id}', { bed_id: id }),
    onSettled,
  })
  return { set, change, remove }
}

/** Record that the person opens the file of a reference: its sound is sent to those of whom that is known. */
export const recordOpening = (versionId: string) =>
  post('/v1/reference-versions/{reference_version_id}/openings', { reference_version_id: versionId })

/** What a version is compared with. */
export type Against = Schemas['SoundComparisonAdd']

/** How a version differs from another sound; asked again until it is made. */
export const comparisonQuery = (takeId: string, against: Against | null) =>
  queryOptions({
    queryKey: queryKeys.comparison(takeId, against),
    queryFn: () => post('/v1/takes/{take_id}/comparisons', { take_id: takeId }, against ?? {}),
    enabled: against !== null,
    retry: false,
    refetchInterval: ({ state }) =>
      state.data && !state.data.is_made && state.data.refusal === null ? AGAIN_MS : false,
  })
