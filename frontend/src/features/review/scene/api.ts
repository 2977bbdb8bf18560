import { keepPreviousData, queryOptions, useQueryClient } from '@tanstack/react-query'

import { answered, api, useMutation } from '@/api'
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
    queryFn: () => answered(api.POST('/v1/takes/{take_id}/scene', { params: { path: { take_id: takeId } } })),
    refetchInterval: ({ state }) => (state.data?.is_ready === false ? AGAIN_MS : false),
    placeholderData: keepPreviousData,
  })

/** Which bands of a version are heard among lanes at these levels, each as "music:-12". */
export const maskingQuery = (takeId: string, lanes: readonly string[], isReady: boolean) =>
  queryOptions({
    queryKey: queryKeys.masking(takeId, lanes.join(' ')),
    queryFn: () =>
      answered(
        api.GET('/v1/takes/{take_id}/masking', { params: { path: { take_id: takeId }, query: { lane: [...lanes] } } }),
      ),
    enabled: isReady,
    placeholderData: keepPreviousData,
  })

export const bedSourcesQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.bedSources(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/bed-sources', { params: { path: { project_id: projectId } } })),
  })

/** Put, change and take away what plays under the sounds of a project or of a category. */
export function useBeds(projectId: string) {
  const client = useQueryClient()
  const onSettled = () => invalidate(client, queryKeys.scene.all)
  const set = useMutation({
    mutationFn: (bed: Schemas['BedSet']) =>
      answered(api.PUT('/v1/projects/{project_id}/beds', { params: { path: { project_id: projectId } }, body: bed })),
    onSettled,
  })
  const change = useMutation({
    mutationFn: ({ id, ...body }: { id: string } & Schemas['BedChange']) =>
      answered(api.PATCH('/v1/beds/{bed_id}', { params: { path: { bed_id: id } }, body })),
    onSettled,
  })
  const remove = useMutation({
    mutationFn: (id: string) => answered(api.DELETE('/v1/beds/{bed_id}', { params: { path: { bed_id: id } } })),
    onSettled,
  })
  return { set, change, remove }
}

/** Record that the person opens the file of a reference: its sound is sent to those of whom that is known. */
export const recordOpening = (versionId: string) =>
  answered(
    api.POST('/v1/reference-versions/{reference_version_id}/openings', {
      params: { path: { reference_version_id: versionId } },
    }),
  )

/** What a version is compared with. */
export type Against = Schemas['SoundComparisonAdd']

/** How a version differs from another sound; asked again until it is made. */
export const comparisonQuery = (takeId: string, against: Against | null) =>
  queryOptions({
    queryKey: queryKeys.comparison(takeId, against),
    queryFn: () =>
      answered(
        api.POST('/v1/takes/{take_id}/comparisons', { params: { path: { take_id: takeId } }, body: against ?? {} }),
      ),
    enabled: against !== null,
    retry: false,
    refetchInterval: ({ state }) =>
      state.data && !state.data.is_made && state.data.refusal === null ? AGAIN_MS : false,
  })
