import { figure } from './format'
import { Meter } from './Meter'
import { type Need, NeedMark } from './NeedMark'
import classes from './NeedSums.module.css'

export interface NeedSum {
  need: Need
  accepted: number
  cues: number
}

/** How many cues of each need are accepted; nothing where all cues are of one need, which a list's sum says already. */
export function NeedSums({ sums }: { sums: readonly NeedSum[] }) {
  if (sums.length < 2) return null
  return (
    <ul className={`small mid flex wrap items-center ${classes.sums}`} aria-label="Accepted by need">
      {sums.map(({ need, accepted, cues }) => {
        const words = `${figure(accepted)} of ${figure(cues)}`
        return (
          <li key={need}>
            <NeedMark need={need} />
            <span className={`inline-flex ${classes.bar}`} aria-hidden="true">
              <Meter thin label={words} whole={cues} parts={[{ value: accepted, tone: 'ok' }]} />
            </span>
            {words}
          </li>
        )
      })}
    </ul>
  )
}
