import { useEffect, useState } from 'react'

/** What waits shows it after this long, never before; `--sl-t-wait` of the sheets is the same. */
const WAIT_MS = 300

/** Whether something has gone on for so long that it must be seen. */
export function useLate(isGoingOn: boolean, afterMs: number = WAIT_MS): boolean {
  const [isLate, setIsLate] = useState(false)
  useEffect(() => {
    if (!isGoingOn) return
    const timer = setTimeout(() => setIsLate(true), afterMs)
    return () => {
      clearTimeout(timer)
      setIsLate(false)
    }
  }, [isGoingOn, afterMs])
  return isGoingOn && isLate
}
