import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { plural } from '@/ui/format'
import { useLazy } from '@/ui/useLazy'

import { cueReferencesQuery } from './api'

const load = () => import('./ReferenceStrip').then((part) => part.ReferenceStrip)

/** How many references a cue has; they are loaded once they are asked for, since most cues are judged without. */
export function ReferencesWhereAny({ projectId, cueId }: { projectId: string; cueId: string }) {
  const { data: references } = useQuery(cueReferencesQuery(projectId, cueId))
  const [isOpen, setOpen] = useState(false)
  const Strip = useLazy(load, isOpen)
  if (references === undefined || references.length === 0) return null
  return (
    <details onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary className="small strong">{plural(references.length, 'reference')}</summary>
      {isOpen && Strip && <Strip projectId={projectId} cueId={cueId} />}
    </details>
  )
}
