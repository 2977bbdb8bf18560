import type { ReviewTake } from '@/judging/api'
import type { StateKind } from '@/ui/State'

export const STATE_OF_TAKE: Record<ReviewTake['state'], StateKind> = {
  received: 'checking',
  conforming: 'to_review',
  returned: 'returned',
  unjudged: 'unjudged',
  approved: 'approved',
  change_requested: 'change_requested',
  set_aside: 'set_aside',
}
