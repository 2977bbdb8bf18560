import { refusalOf, sentence } from '@/app/Form'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Studio.module.css'

/** A refusal of something that was pressed in a card, said in the card. */
export function CardProblem({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  const refusal = refusalOf(error)
  return (
    <div className={classes.problem}>
      <ProblemNote
        detail={sentence(refusal?.detail ?? 'Can’t reach Soundlist.')}
        fix={refusal?.fix ? sentence(refusal.fix) : undefined}
      />
    </div>
  )
}
