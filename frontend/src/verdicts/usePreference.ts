import { useState } from 'react'

function kept(key: string): string | null {
  try {
    return localStorage.getItem(key)
  } catch {
    return null
  }
}

/** A switch of one person, kept on this device. */
export function usePreference(key: string, isOnFirst: boolean): [boolean, (isOn: boolean) => void] {
  const [isOn, setOn] = useState(() => (kept(key) ?? String(isOnFirst)) === 'true')
  const set = (next: boolean) => {
    setOn(next)
    try {
      localStorage.setItem(key, String(next))
    } catch {
      // A browser that keeps nothing starts as everybody does.
    }
  }
  return [isOn, set]
}
