import { useCallback, useState } from 'react'

import { keepLastCue, lastCue } from '../lastCue'
import type { CueRow } from '../rows'

const NONE: ReadonlySet<string> = new Set()

/** Which of the shown cues has the keys, and which are picked to change together. */
export function useCueSelection(projectId: string, shown: CueRow[]) {
  const [picked, setPicked] = useState<ReadonlySet<string>>(NONE)
  const [anchor, setAnchor] = useState<string | null>(null)
  const [selectedId, setSelectedOnly] = useState(() => lastCue(projectId))
  const at = shown.findIndex(({ id }) => id === selectedId)

  const select = useCallback(
    (id: string) => {
      keepLastCue(projectId, id)
      setSelectedOnly(id)
    },
    [projectId],
  )
  const step = (by: 1 | -1) => {
    const to = shown[at < 0 ? (by > 0 ? 0 : shown.length - 1) : Math.min(shown.length - 1, Math.max(0, at + by))]
    if (to) select(to.id)
  }
  const pick = useCallback(
    (id: string, extend: boolean) => {
      select(id)
      const from = extend ? shown.findIndex((row) => row.id === anchor) : -1
      const to = shown.findIndex((row) => row.id === id)
      setPicked((before) => {
        const after = new Set(before)
        if (from >= 0) {
          for (const row of shown.slice(Math.min(from, to), Math.max(from, to) + 1)) after.add(row.id)
        } else if (!after.delete(id)) after.add(id)
        return after
      })
      setAnchor(id)
    },
    [select, shown, anchor],
  )
  return { selected: shown[at], selectedId, select, step, picked, pick, unpick: () => setPicked(NONE) }
}
