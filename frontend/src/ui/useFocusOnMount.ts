import { type RefObject, useEffect, useRef } from 'react'

/** Takes the focus when it appears: for a field that somebody has just asked for, never for one that a page begins with. */
export function useFocusOnMount<T extends HTMLElement>(wanted = true): RefObject<T | null> {
  const ref = useRef<T>(null)
  useEffect(() => {
    if (wanted) ref.current?.focus()
  }, [wanted])
  return ref
}
