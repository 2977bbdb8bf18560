import { useQuery } from '@tanstack/react-query'

import { useLazy } from '@/ui/useLazy'

import { cueVoiceLineQuery } from './api'

const load = () => import('./VoiceLineStrip').then((part) => part.VoiceLineStrip)

/** The voice line that a cue is for, loaded only where it is one. */
export function VoiceLineWhereAny({ projectId, cueId }: { projectId: string; cueId: string }) {
  const { data: line } = useQuery(cueVoiceLineQuery(projectId, cueId))
  const Strip = useLazy(load, line !== undefined && line !== null)
  return Strip && line ? <Strip projectId={projectId} line={line} /> : null
}
