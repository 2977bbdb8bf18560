import { queryById } from '@/api'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type Loss = components['schemas']['LossRead']

/** What a game file lost against its master; a file is never altered, so it is asked once. */
export const lossQuery = queryById('/v1/renders/{render_id}/loss', queryKeys.loss, {
  staleTime: Infinity,
  retry: false,
})
