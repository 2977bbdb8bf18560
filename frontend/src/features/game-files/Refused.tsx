import { ApiProblem } from '@/api'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Files.module.css'
import { sentence } from './words'

/** What was refused, in the card where it was asked. */
export function Refused({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  const problem = error instanceof ApiProblem ? error : null
  return (
    <div className={classes.inside}>
      <ProblemNote
        detail={problem ? sentence(problem.detail) : 'Something went wrong in the page.'}
        fix={problem?.fix ? sentence(problem.fix) : undefined}
      />
    </div>
  )
}
