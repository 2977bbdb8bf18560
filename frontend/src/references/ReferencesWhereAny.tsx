import { useQuery } from '@tanstack/react-query'

import { useLazy } from '@/ui/useLazy'

import { cueReferencesQuery } from './api'

const load = () => import('./ReferenceStrip').then((part) => part.ReferenceStrip)

/** The references of a cue, loaded only where there are any: for pages that most people open without them. */
export function ReferencesWhereAny({ projectId, cueId }: { projectId: string; cueId: string }) {
  const { data: references } = useQuery(cueReferencesQuery(projectId, cueId))
  const Strip = useLazy(load, references !== undefined && references.length > 0)
  return Strip && <Strip projectId={projectId} cueId={cueId} />
}
