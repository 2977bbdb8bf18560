import { ApiProblem } from '@/api'
import { ProblemNote } from '@/ui/ProblemNote'

/** What was refused, said where it happened. */
export function Refusal({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  if (!(error instanceof ApiProblem)) return <ProblemNote detail="Can’t reach Soundlist." />
  return <ProblemNote detail={`${error.detail}.`} fix={error.fix ?? undefined} />
}
