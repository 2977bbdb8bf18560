import type { Need } from '@/ui/NeedMark'

import { NEEDS } from './words'

/** The next need in turn: must, should, wish, must. */
export function nextNeed(need: Need): Need {
  const at = NEEDS.findIndex(({ value }) => value === need)
  return NEEDS[(at + 1) % NEEDS.length]?.value ?? 'must'
}
