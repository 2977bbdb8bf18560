import { useQueryClient } from '@tanstack/react-query'

import { put, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { showToast } from '@/app/toast'

import type { ReviewTake } from './api'

/** Say what a version is among alternates; null takes its label away. */
export function useSetLabel() {
  const client = useQueryClient()
  return useMutation({
    mutationFn: ({ takeId, label }: { takeId: string; label: string | null }) =>
      put('/v1/takes/{take_id}/label', { take_id: takeId }, { label }),
    // Awaited: the next key labels what is shown then.
    onSettled: (_, __, { takeId }) =>
      invalidate(
        client,
        queryKeys.cueReview.all,
        queryKeys.reviewQueue.all,
        queryKeys.take(takeId),
        queryKeys.takeHistory(takeId),
        queryKeys.cueTakes.all,
        queryKeys.delivery.all,
        queryKeys.playlist.all,
      ),
  })
}

/** Label a version by its name, and say so; one at a time. */
export function useLabelling() {
  const label = useSetLabel()
  return (take: ReviewTake, name: string, words: string | null, onLabelled: () => void) => {
    if (label.isPending) return
    const onSuccess = () => {
      onLabelled()
      showToast(`${name} ${words === null ? 'has no label' : `is labelled “${words}”`}.`)
    }
    label.mutate({ takeId: take.id, label: words }, { onSuccess })
  }
}
