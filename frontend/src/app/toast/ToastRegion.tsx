import { useEffect, useRef, useState, useSyncExternalStore } from 'react'

import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'

import { useHotkeys } from '../keys'
import { dismissToast, type Toast, TOAST_MS, toastStore } from './store'
import classes from './Toast.module.css'

/** The place at the bottom left where what was just done can be taken back. */
export function ToastRegion() {
  const toast = useSyncExternalStore(toastStore.subscribe, toastStore.get)
  return (
    <div role="status" className={classes.region}>
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
      className={`${classes.toast} on-ink`}
      data-held={held || undefined}
      onMouseEnter={() => setHeld(true)}
      onMouseLeave={() => setHeld(false)}
      onFocus={() => setHeld(true)}
      onBlur={() => setHeld(false)}
    >
      <Icon name="tick" />
      <span className="grow">{toast.text}</span>
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
      <span className={classes.line} style={{ animationDuration: `${TOAST_MS}ms` }} />
    </div>
  )
}
