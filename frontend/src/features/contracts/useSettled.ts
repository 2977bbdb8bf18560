import { useEffect, useState } from 'react'

const SETTLED_MS = 400 // after the last key, the preview is requested

/** A value once it has not changed for a moment. */
export function useSettled<T>(value: T): T {
  const [settled, setSettled] = useState(value)
  useEffect(() => {
    const waiting = setTimeout(() => setSettled(value), SETTLED_MS)
    return () => clearTimeout(waiting)
  }, [value])
  return settled
}
