import { Tooltip } from '@mantine/core'
import type { ReactNode } from 'react'

/** A state that says on hover, focus or touch why it is so. */
export function StateReason({
  reason,
  className,
  children,
}: {
  reason: string
  className: string
  children: ReactNode
}) {
  return (
    <Tooltip label={reason} events={{ hover: true, focus: true, touch: true }} multiline>
      <button type="button" className={className}>
        {children}
        <span className="visually-hidden">: {reason}</span>
      </button>
    </Tooltip>
  )
}
