import { ApiProblem } from '@/api'
import { ended } from './findings'
import { ProblemNote } from '@/ui/ProblemNote'

interface RefusalProps {
  error: unknown
  /** What was to be done, where the sentence alone would not say: a file's name. */
  about?: string
}

/** What the server refused, and what to do; nothing where nothing was refused. */
export function Refusal({ error, about }: RefusalProps) {
  if (error === null || error === undefined) return null
  const problem = error instanceof ApiProblem ? error : null
  const detail = ended(problem?.detail ?? 'Something went wrong in the page.')
  return (
    <ProblemNote detail={about ? `${about}: ${detail}` : detail} fix={problem?.fix ? ended(problem.fix) : undefined} />
  )
}
