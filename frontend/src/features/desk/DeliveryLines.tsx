import { useState } from 'react'

import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'
import { useLazy } from '@/ui/useLazy'

import classes from './Delivery.module.css'
import { DeliveryLine, type FileActions } from './DeliveryLine'
import type { DeliveryRow, DeliveryRows } from './rows'

interface LinesProps extends FileActions {
  rows: DeliveryRows
}

/** More rows than this are drawn only where they are seen. */
const ALL_AT_ONCE = 60
const loadMany = () => import('./ManyLines').then(({ ManyLines }) => ManyLines)

/** Every file of the delivery; what is done folds into one line. */
export function DeliveryLines({ rows: { open, done }, ...actions }: LinesProps) {
  const [unfolded, setUnfolded] = useState(false)
  const shown = unfolded ? [...open, ...done] : open
  const isLong = shown.length > ALL_AT_ONCE
  const ManyLines = useLazy(loadMany, isLong)
  return (
    <>
      {ManyLines && isLong ? (
        <ManyLines rows={shown} {...actions} />
      ) : (
        <Lines rows={shown.slice(0, ALL_AT_ONCE)} {...actions} />
      )}
      {done.length > 0 && (
        <div className={`flex items-center gap-3 border-t ${classes.folded}`}>
          <StatusBadge kind="conforming">{plural(done.length, 'file')} checked</StatusBadge>
          <button
            type="button"
            className="link small mid"
            aria-expanded={unfolded}
            onClick={() => setUnfolded(!unfolded)}
          >
            {unfolded ? 'Hide' : 'Show'}
          </button>
        </div>
      )}
    </>
  )
}

function Lines({ rows, ...actions }: { rows: readonly DeliveryRow[] } & FileActions) {
  if (rows.length === 0) return null
  return (
    <ul aria-label="Files in this delivery">
      {rows.map((row) => (
        <li key={row.id} className={`grid items-center gap-14px border-b ${classes.line}`} data-kind={row.state}>
          <DeliveryLine row={row} {...actions} />
        </li>
      ))}
    </ul>
  )
}
