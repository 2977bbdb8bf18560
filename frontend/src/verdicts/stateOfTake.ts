import type { components } from '@/api/schema.gen'
import type { StateKind } from '@/ui/StatusBadge'

/** How a take stands, as every page shows it. */
export const STATE_OF_TAKE: Record<components['schemas']['TakeState'], StateKind> = {
  received: 'checking',
  conforming: 'to_review',
  returned: 'returned',
  unjudged: 'unjudged',
  approved: 'approved',
  change_requested: 'change_requested',
  set_aside: 'set_aside',
}
