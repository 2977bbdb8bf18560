import { useQueryClient } from '@tanstack/react-query'

import { put, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'

/** Check an item of the checklist for a version, or take that back. */
export function useCheckItem(cueId: string) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ takeId, itemId, isChecked }: { takeId: string; itemId: string; isChecked: boolean }) =>
      put(
        '/v1/takes/{take_id}/checklist/{checklist_item_id}',
        { take_id: takeId, checklist_item_id: itemId },
        { is_checked: isChecked },
      ),
    // Awaited: the next press of the key checks the item after this one.
    onSettled: () => invalidate(client, queryKeys.cueReview(cueId)),
  })
}
