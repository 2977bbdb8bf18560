import { useInfiniteQuery } from '@tanstack/react-query'

import { answered, api } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type OtherSound = components['schemas']['OtherSound']

/** The sounds of other designers that the project lets its designers hear, the newest first. */
export const useOtherSounds = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.otherSounds(projectId),
    queryFn: ({ pageParam: cursor }) =>
      answered(
        api.GET('/v1/projects/{project_id}/other-sounds', {
          params: { path: { project_id: projectId }, query: { cursor } },
        }),
      ),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })
