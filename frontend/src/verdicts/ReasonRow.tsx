import { useLayoutEffect, useRef } from 'react'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'

import classes from './ChangeForm.module.css'

interface ReasonRowProps {
  /** The studio's list, in the order of the digits. */
  reasons: readonly string[]
  /** What a digit does, before the reason: "Approve shield_hit A because". */
  title: string
  onReason: (reason: string) => void
  /** What 0 does. */
  none?: { title: string; run: () => void }
  onClose: () => void
}

/** The reasons of a verdict, each on its digit, which gives the verdict. */
export function ReasonRow({ reasons, title, onReason, none, onClose }: ReasonRowProps) {
  const group = useRef<HTMLDivElement>(null)
  // The group and no button in it: Space plays, and decides nothing.
  useLayoutEffect(() => group.current?.focus(), [])
  useHotkeys([
    ...reasons.map((reason, index) => ({
      keys: String(index + 1),
      label: 'Decide with this reason',
      group: 'Review',
      unlisted: index > 0,
      run: () => onReason(reason),
    })),
    ...(none ? [{ keys: '0', label: none.title, group: 'Review', run: none.run }] : []),
    { keys: 'Escape', label: 'Close without deciding', group: 'Review', run: onClose },
  ])
  return (
    <div ref={group} tabIndex={-1} role="group" aria-label={title} className="grid gap-2">
      <p className="small strong">{title}</p>
      <div className={`flex wrap gap-6px ${classes.reasons}`}>
        {reasons.map((reason, index) => (
          <Button key={reason} keys={String(index + 1)} onClick={() => onReason(reason)}>
            {reason}
          </Button>
        ))}
        {none && (
          <Button keys="0" onClick={none.run}>
            {none.title}
          </Button>
        )}
        <Button variant="quiet" keys="Escape" onClick={onClose}>
          Close
        </Button>
      </div>
    </div>
  )
}
