import type { ReactNode } from 'react'

import classes from './FilterChip.module.css'
import { Icon } from './Icon'
import { STATES, type StateKind } from './StatusBadge'

interface FilterChipProps {
  /** The state it filters by; none for "All". */
  kind?: StateKind
  children?: ReactNode
  count: number
  pressed: boolean
  onPress: () => void
}

/** One filter of a list with how many it leaves. */
export function FilterChip({ kind, children, count, pressed, onPress }: FilterChipProps) {
  const face = kind && STATES[kind]
  return (
    <button
      type="button"
      className={face ? `${classes.chip} tone-${face.tone}` : classes.chip}
      aria-pressed={pressed}
      onClick={onPress}
    >
      {face && <Icon name={face.icon} />}
      <span className={face && !('resting' in face) ? 'toned' : undefined}>{children ?? face?.word}</span>{' '}
      <span className="ink">{count}</span>
    </button>
  )
}
