import { useInfiniteQuery } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type OtherSound = components['schemas']['OtherSound']

/** The sounds of other designers that the project lets its designers hear, the newest first. */
export const useOtherSounds = (projectId: string) =>
  useInfiniteQuery({
    queryKey: queryKeys.otherSounds(projectId),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/other-sounds', { project_id: projectId, cursor }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })
