import { useQuery } from '@tanstack/react-query'

import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import { phasesQuery } from './api'
import { PHASE_WORDS } from './words'

/** Warns where work is ordered or sent for a phase that is not open yet; it holds nothing back. */
export function ClosedGateNote({ projectId, cueIds }: { projectId: string; cueIds: readonly string[] }) {
  const { data } = useQuery(phasesQuery(projectId))
  const early = new Set(data?.closed_cue_ids)
  const count = new Set(cueIds.filter((id) => early.has(id))).size
  const last = data?.phases.findLast(({ is_open: isOpen }) => isOpen)
  if (count === 0 || !last) return null
  return (
    <p role="status" className="small tone-warn toned">
      <Icon name="triangle" /> {`${plural(count, 'cue')} of a later phase: ${PHASE_WORDS[last.phase]} is not done.`}
    </p>
  )
}
