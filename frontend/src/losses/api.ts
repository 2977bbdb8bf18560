import { queryOptions } from '@tanstack/react-query'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type Loss = components['schemas']['LossRead']

/** What a game file lost against its master; a file is never altered, so it is asked once. */
export const lossQuery = (renderId: string) =>
  queryOptions({
    queryKey: queryKeys.loss(renderId),
    queryFn: () => get('/v1/renders/{render_id}/loss', { render_id: renderId }),
    staleTime: Infinity,
    retry: false,
  })
