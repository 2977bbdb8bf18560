import { useRef, useState } from 'react'

import { useDraft } from '@/app/drafts'

import { NO_MARKS, type Spotted } from './marks'

const UNDONE_AT_MOST = 200

/** A function of the marks as they are, since a key may be let go before the page is drawn again. */
export type ChangeMarks = (next: (now: Spotted) => Spotted, step?: string | null) => void

/** The marks of one clip, kept in this browser, with every step back. */
export function useMarks(referenceId: string) {
  const [spotted, setSpotted, draft] = useDraft<Spotted>(draftKey(referenceId), NO_MARKS)
  const [earlier, setEarlier] = useState<readonly Spotted[]>([])
  const lastStep = useRef<string | null>(null)
  /** Changes of the same name, such as typing on, are one step back. */
  const change: ChangeMarks = (next, step = null) => {
    if (step === null || step !== lastStep.current) {
      setEarlier((steps) => [...steps, spotted].slice(-UNDONE_AT_MOST))
    }
    lastStep.current = step
    setSpotted(next)
  }
  const undo = () => {
    const before = earlier.at(-1)
    if (before === undefined) return
    lastStep.current = null
    setEarlier(earlier.slice(0, -1))
    setSpotted(before)
  }
  return { spotted, change, undo, mayUndo: earlier.length > 0, draft }
}

export const draftKey = (referenceId: string): string => `spotting:${referenceId}`
