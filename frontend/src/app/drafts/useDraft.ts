import { type Dispatch, type SetStateAction, useEffect, useRef, useState } from 'react'

import { keepDraft, keptDraft } from './store'

export interface Draft {
  /** What is shown was typed before this page was opened. */
  isRestored: boolean
  /** What is shown differs from what the form began with, which is what is saved. */
  isChanged: boolean
  /** Go back to what the form began with. */
  discard: () => void
}

interface Held<T> {
  key: string
  begun: T
  value: T
  isRestored: boolean
}

const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b)

function opened<T>(key: string, initial: T | (() => T)): Held<T> {
  const begun = typeof initial === 'function' ? (initial as () => T)() : initial
  const kept = keptDraft<T>(key)
  return { key, begun, value: kept ?? begun, isRestored: kept !== null }
}

/** What a form begins with was read anew, by its own saving for one, and nothing is typed: the form follows. */
function follows<T>({ begun, value }: Held<T>, initial: T | (() => T)): boolean {
  return typeof initial !== 'function' && same(value, begun) && !same(initial, begun)
}

/**
 * State of a form that outlives reload, Escape, Back, a lost session and a lost server. `discard` also ends a form that
 * was sent. The key names what the form is about; what is kept must be plain data, and never a password or a token.
 */
export function useDraft<T>(
  key: string,
  initial: T | (() => T),
): [value: T, set: Dispatch<SetStateAction<T>>, draft: Draft] {
  const [held, setHeld] = useState(() => opened(key, initial))
  let now = held
  if (held.key !== key || follows(held, initial)) {
    now = opened(key, initial)
    setHeld(now)
  }
  const unkept = useRef(false)
  const { begun, value } = now
  useEffect(() => {
    unkept.current = !keepDraft(key, same(value, begun) ? null : value) && !same(value, begun)
  }, [key, value, begun])
  useEffect(() => {
    // Asked only where the browser could not keep it.
    const warn = (event: BeforeUnloadEvent) => {
      if (unkept.current) event.preventDefault()
    }
    window.addEventListener('beforeunload', warn)
    return () => window.removeEventListener('beforeunload', warn)
  }, [])

  const set: Dispatch<SetStateAction<T>> = (next) =>
    setHeld((before) => ({
      ...before,
      value: typeof next === 'function' ? (next as (now: T) => T)(before.value) : next,
    }))
  const discard = () => {
    keepDraft(key, null)
    setHeld((before) => ({ ...before, value: before.begun, isRestored: false }))
  }
  const isChanged = !same(value, begun)
  return [value, set, { isRestored: now.isRestored && isChanged, isChanged, discard }]
}
