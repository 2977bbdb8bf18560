import { Refusal } from '@/ui/Refusal'

import classes from './Studio.module.css'

/** A refusal of something that was pressed in a card, said in the card. */
export function CardProblem({ error }: { error: unknown }) {
  if (error === null || error === undefined) return null
  return (
    <div className={classes.problem}>
      <Refusal error={error} />
    </div>
  )
}
