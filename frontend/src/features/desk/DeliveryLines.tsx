import { useVirtualizer } from '@tanstack/react-virtual'
import { useRef, useState } from 'react'

import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { State } from '@/ui/State'

import classes from './Delivery.module.css'
import type { DeliveryRow, DeliveryRows } from './rows'

interface LinesProps {
  rows: DeliveryRows
  onStop: (uploadId: string) => void
  onDismiss: (uploadId: string) => void
  onRecheck: (takeId: string) => void
}

/** More rows than this are drawn only where they are seen. */
const ALL_AT_ONCE = 60
const ROW_PX = 33

/** Every file of the delivery; what is done folds into one line. */
export function DeliveryLines({ rows: { open, done }, ...does }: LinesProps) {
  const [unfolded, setUnfolded] = useState(false)
  const shown = unfolded ? [...open, ...done] : open
  return (
    <>
      {shown.length > ALL_AT_ONCE ? <ManyLines rows={shown} {...does} /> : <Lines rows={shown} {...does} />}
      {done.length > 0 && (
        <div className={classes.folded}>
          <State kind="conforming">{plural(done.length, 'file')} checked</State>
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

type Does = Omit<LinesProps, 'rows'>

function Lines({ rows, ...does }: { rows: readonly DeliveryRow[] } & Does) {
  if (rows.length === 0) return null
  return (
    <ul aria-label="Files in this delivery">
      {rows.map((row) => (
        <li key={row.id} className={classes.line} data-kind={row.state}>
          <Line row={row} {...does} />
        </li>
      ))}
    </ul>
  )
}

function ManyLines({ rows, ...does }: { rows: readonly DeliveryRow[] } & Does) {
  const ref = useRef<HTMLDivElement>(null)
  const virtual = useVirtualizer({
    count: rows.length,
    getScrollElement: () => ref.current,
    estimateSize: () => ROW_PX,
    overscan: 12,
    getItemKey: (index) => rows[index]?.id ?? index,
    measureElement: (element) => element.getBoundingClientRect().height,
  })
  return (
    <div
      ref={ref}
      className={classes.many}
      // The keyboard scrolls it too.
      // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      tabIndex={0}
      role="region"
      aria-label={`${plural(rows.length, 'file')}, scrolls`}
    >
      <ul aria-label="Files in this delivery" style={{ height: virtual.getTotalSize(), position: 'relative' }}>
        {virtual.getVirtualItems().map((item) => {
          const row = rows[item.index]
          return (
            row && (
              <li
                key={item.key}
                ref={virtual.measureElement}
                data-index={item.index}
                className={`${classes.line} ${classes.placed}`}
                data-kind={row.state}
                aria-setsize={rows.length}
                aria-posinset={item.index + 1}
                style={{ transform: `translateY(${item.start}px)` }}
              >
                <Line row={row} {...does} />
              </li>
            )
          )
        })}
      </ul>
    </div>
  )
}

function Line({ row, onStop, onDismiss, onRecheck }: { row: DeliveryRow } & Does) {
  const { name, label, state, share, detail, does, uploadId, takeId } = row
  return (
    <>
      <span className={`mono ${classes.name}`}>{name}</span>
      <span className={`mono dim ${classes.label}`}>{label}</span>
      <span className={classes.detail} data-bar={share !== null || undefined}>
        {share !== null && (
          <Meter thin label={`${name}: ${Math.floor(share * 100)} % here`} whole={1} parts={[{ value: share }]} />
        )}
        <span className="small mid">{detail}</span>
      </span>
      <State kind={state} />
      <span className={classes.does}>
        {does === 'stop' && uploadId && (
          <Button square variant="quiet" icon="cross" aria-label={`Stop ${name}`} onClick={() => onStop(uploadId)} />
        )}
        {does === 'dismiss' && uploadId && (
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove ${name} from the list`}
            onClick={() => onDismiss(uploadId)}
          />
        )}
        {does === 'recheck' && takeId && (
          <Button
            square
            variant="quiet"
            icon="turn"
            aria-label={`Check ${name} again`}
            onClick={() => onRecheck(takeId)}
          />
        )}
      </span>
    </>
  )
}
