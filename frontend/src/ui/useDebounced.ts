import { useEffect, useState } from 'react'

const DEBOUNCE_MS = 400 // after the last key, the server is asked

/** A value once it has not changed for a moment. */
export function useDebounced<T>(value: T): T {
  const [debounced, setDebounced] = useState(value)
  useEffect(() => {
    const waiting = setTimeout(() => setDebounced(value), DEBOUNCE_MS)
    return () => clearTimeout(waiting)
  }, [value])
  return debounced
}
