import { useQueryClient } from '@tanstack/react-query'

import { put, queryById, useMutation } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export const membersSeeQuery = queryById('/v1/studios/{studio_id}/members-see', queryKeys.membersSee)

export function useSetMembersSee(studioId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (membersSee: components['schemas']['MembersSee']) =>
      put('/v1/studios/{studio_id}/members-see', { studio_id: studioId }, { members_see: membersSee }),
    onSuccess: () => client.invalidateQueries(),
  })
}
