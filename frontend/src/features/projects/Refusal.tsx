import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Project.module.css'
import { refusal } from './words'

/** A refusal of something that was pressed in a card, said in the card. */
export function Refusal({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  return (
    <div className={classes.refusal}>
      <ProblemNote {...refusal(error)} />
    </div>
  )
}
