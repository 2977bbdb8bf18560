import { useEffect } from 'react'

/** Run at the first sign of a person: what is likely needed next is loaded then, rather than with the page. */
export function useFirstInteraction(run: () => void): void {
  useEffect(() => {
    const ending = new AbortController()
    const once = () => {
      ending.abort()
      run()
    }
    for (const sign of ['pointermove', 'pointerdown', 'keydown']) {
      globalThis.addEventListener(sign, once, { signal: ending.signal, passive: true })
    }
    return () => ending.abort()
  }, [run])
}
