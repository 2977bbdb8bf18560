import { useEffect, useRef, useState, useSyncExternalStore } from 'react'

import { isSending, subscribeSending } from '@/api'
import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'

import { useHotkeys } from '../keys'
import { dismissToast, type Toast, TOAST_MS, toastStore } from './store'
import classes from './StatusSlot.module.css'
import { useIsLoading } from './useIsLoading'
import { useLate } from './useLate'

/**
 * The place at the end of the bar for what goes on: what was just done and can be taken back, and that a write waits for
 * its answer. It covers nothing: on a phone it is a line above the bar of screens, for which the page makes room.
 */
export function StatusSlot() {
  const toast = useSyncExternalStore(toastStore.subscribe, toastStore.get)
  const isSendingLate = useLate(useSyncExternalStore(subscribeSending, isSending))
  const isLoadingLate = useLate(useIsLoading())
  const isLate = isSendingLate || isLoadingLate
  return (
    <div
      role="status"
      className={`flex items-center gap-3 min-w-0 ${classes.slot}`}
      data-filled={isLate || toast !== null || undefined}
    >
      {isLate && (
        <span className={`row dim text-small nowrap ${classes.sending}`}>
          <span className="ring" aria-hidden="true" />
          {isSendingLate ? 'Sending…' : 'Loading…'}
        </span>
      )}
      {toast && <ToastLine key={toast.id} toast={toast} />}
    </div>
  )
}

function ToastLine({ toast }: { toast: Toast }) {
  const [held, setHeld] = useState(false)
  const left = useRef(TOAST_MS)

  useEffect(() => {
    if (held) return
    const from = performance.now()
    const timer = setTimeout(() => dismissToast(toast.id), left.current)
    return () => {
      clearTimeout(timer)
      left.current = Math.max(0, left.current - (performance.now() - from))
    }
  }, [held, toast.id])

  const undo = () => {
    dismissToast(toast.id)
    void toast.undo?.()
  }
  useHotkeys([
    { keys: 'u', label: 'Undo what was just done', group: 'Everywhere', run: undo, disabled: toast.undo === undefined },
  ])

  return (
    // Pointing at it or progress in it stops its clock; there is nothing to press on the line itself.
    // eslint-disable-next-line jsx-a11y/no-static-element-interactions
    <div
      className={`row on-ink overflow-hidden relative min-w-0 min-h-28px rounded text-small leading-small narrow-min-h-44px ${classes.toast}`}
      data-held={held || undefined}
      onMouseEnter={() => setHeld(true)}
      onMouseLeave={() => setHeld(false)}
      onFocus={() => setHeld(true)}
      onBlur={() => setHeld(false)}
    >
      <Icon name="tick" />
      <span className={`min-w-0 ${classes.text}`}>{toast.text}</span>
      {toast.undo && (
        <Button variant="quiet" className={classes.undo} keys="u" onClick={undo}>
          Undo
        </Button>
      )}
      <Button
        variant="quiet"
        className={classes.close}
        icon="cross"
        square
        aria-label="Close"
        onClick={() => dismissToast(toast.id)}
      />
      <span className={`absolute bottom-0 w-full ${classes.line}`} style={{ animationDuration: `${TOAST_MS}ms` }} />
    </div>
  )
}
