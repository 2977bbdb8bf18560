import { type RefObject, useEffect, useRef } from 'react'

/** Takes the focus when it appears: for a field that the person has just opened, never for a page's first field. */
export function useFocusOnMount<T extends HTMLElement>(enabled = true): RefObject<T | null> {
  const ref = useRef<T>(null)
  useEffect(() => {
    if (enabled) ref.current?.focus()
  }, [enabled])
  return ref
}
