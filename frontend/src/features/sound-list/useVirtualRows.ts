import { useWindowVirtualizer } from '@tanstack/react-virtual'
import { type RefObject, useLayoutEffect, useState } from 'react'

/** Up to here every row is drawn; beyond it only those near the window. */
const DRAWN_WHOLE = 200
const AROUND = 14

interface VirtualRows {
  /** The rows to draw, by their place. */
  places: number[]
  /** Empty height above and below them. */
  beforePx: number
  afterPx: number
  measure: ((row: Element | null) => void) | undefined
  scrollTo: (place: number) => void
}

/** Draw a long table only where it is looked at, in the page's own scroll. */
export function useVirtualRows(
  count: number,
  estimatePx: (place: number) => number,
  keyOf: (place: number) => string,
  table: RefObject<HTMLElement | null>,
): VirtualRows {
  const enabled = count > DRAWN_WHOLE
  const [topPx, setTopPx] = useState(0)
  useLayoutEffect(() => {
    if (!enabled) return
    const read = () => setTopPx((table.current?.getBoundingClientRect().top ?? 0) + window.scrollY)
    read()
    // What stands above the table opens and closes.
    const observer = new ResizeObserver(read)
    observer.observe(document.body)
    return () => observer.disconnect()
  }, [enabled, table])
  const virtualizer = useWindowVirtualizer({
    count,
    estimateSize: estimatePx,
    getItemKey: keyOf,
    overscan: AROUND,
    scrollMargin: topPx,
    scrollPaddingStart: 80,
    scrollPaddingEnd: 80,
    enabled,
  })
  if (!enabled) {
    return {
      places: Array.from({ length: count }, (_, place) => place),
      beforePx: 0,
      afterPx: 0,
      measure: undefined,
      scrollTo: () => undefined,
    }
  }
  const items = virtualizer.getVirtualItems()
  return {
    places: items.map(({ index }) => index),
    beforePx: (items[0]?.start ?? topPx) - topPx,
    afterPx: virtualizer.getTotalSize() - ((items.at(-1)?.end ?? topPx) - topPx),
    measure: virtualizer.measureElement,
    scrollTo: (place) => virtualizer.scrollToIndex(place, { align: 'auto' }),
  }
}
