import { useEffect, useState } from 'react'
import { flushSync } from 'react-dom'

import { keepDraft, keptDraft } from '@/app/drafts'

import type { Writing } from './Composer'

/** The comment that is being written on a cue; what is typed is kept as a draft. */
export function useWriting(cueId: string) {
  const [writing, setWriting] = useState<Writing | null>(null)
  useEffect(() => {
    if (writing !== null) keepDraft(`comment:${cueId}`, writing.text.trim() === '' ? null : writing)
  }, [cueId, writing])
  /** Open the field, with the draft where nothing is given. */
  const begin = (text: string, startS: number, endS?: number) => {
    const kept = text === '' ? keptDraft<Writing>(`comment:${cueId}`) : null
    flushSync(() => setWriting(kept ? { ...kept, isRestored: true } : { text, startS, endS }))
  }
  return { writing, setWriting, begin }
}
