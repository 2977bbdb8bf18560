import { useQuery } from '@tanstack/react-query'

import { queryById } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type ReviewReasons = components['schemas']['ReviewReasonsRead']
export type ReasonKind = keyof ReviewReasons

const NONE: readonly string[] = []

/** The lists of reasons and labels of the studio that a project belongs to. */
export const reasonsQuery = queryById('/v1/projects/{project_id}/review-reasons', queryKeys.reviewReasons)

/** What the studio says most, each on its digit; nothing until it is here, so that no digit means something else. */
export function useReasons(projectId: string): Record<ReasonKind, readonly string[]> {
  const { data } = useQuery(reasonsQuery(projectId))
  return {
    change: data?.change.reasons ?? NONE,
    pick: data?.pick.reasons ?? NONE,
    label: data?.label.reasons ?? NONE,
  }
}
