import { type RefObject, useEffect, useRef } from 'react'

/** Takes the focus when it appears: for a field that the person has just opened, never for a page's first field. */
export function useFocusOnMount<T extends HTMLElement>(wanted = true): RefObject<T | null> {
  const ref = useRef<T>(null)
  useEffect(() => {
    if (wanted) ref.current?.focus()
  }, [wanted])
  return ref
}
