import { useVirtualizer } from '@tanstack/react-virtual'
import { useRef } from 'react'

import { plural } from '@/ui/format'

import classes from './Delivery.module.css'
import { DeliveryLine, type FileActions } from './DeliveryLine'
import type { DeliveryRow } from './rows'

const ROW_PX = 33

/** Files in their hundreds, drawn only where they are seen. */
export function ManyLines({ rows, ...actions }: { rows: readonly DeliveryRow[] } & FileActions) {
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
      className={`border-b overflow-y-auto ${classes.many}`}
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
                className={`grid items-center gap-14px border-b ${classes.line} absolute ${classes.placed}`}
                data-kind={row.state}
                aria-setsize={rows.length}
                aria-posinset={item.index + 1}
                style={{ transform: `translateY(${item.start}px)` }}
              >
                <DeliveryLine row={row} {...actions} />
              </li>
            )
          )
        })}
      </ul>
    </div>
  )
}
