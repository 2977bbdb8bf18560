import { plural, shortDay } from '@/ui/format'

import classes from './Roster.module.css'
import { type Week, WEEK_WORDS } from './words'

const WEEK_MS = 7 * 24 * 3600 * 1000

/** The Monday of a week, counted from the first that is shown. */
const mondayOf = (firstOn: string, place: number): string =>
  new Date(Date.parse(`${firstOn}T00:00:00Z`) + place * WEEK_MS).toISOString().slice(0, 10)

/** "booked 23 Nov to 30 Nov, free from 7 Dec": runs of equal weeks, by their Mondays. */
export function weeksInWords(weeks: readonly Week[], firstOn: string): string {
  const runs: { state: Week; from: number }[] = []
  for (const [place, state] of weeks.entries()) if (runs.at(-1)?.state !== state) runs.push({ state, from: place })
  const only = runs[0]
  if (only && runs.length === 1) return `${WEEK_WORDS[only.state]} for ${plural(weeks.length, 'week')}`
  return runs.map(({ state, from }) => `${WEEK_WORDS[state]} from ${shortDay(mondayOf(firstOn, from))}`).join(', ')
}

interface WeeksProps {
  weeks: readonly Week[]
  firstOn: string
}

/** Twelve weeks at a glance: hatched is booked, half filled is half days. */
export function Weeks({ weeks, firstOn }: WeeksProps) {
  const words = weeksInWords(weeks, firstOn)
  return (
    <span
      className={`inline-flex items-center gap-2px ${classes.weeks}`}
      role="img"
      aria-label={`Next 12 weeks: ${words}`}
      title={words}
    >
      {weeks.map((state, place) => (
        <span key={place} className={`border-edge rounded-2px bg-surface ${classes.week}`} data-state={state} />
      ))}
    </span>
  )
}

/** The same with the Monday of every fourth week, and what the marks mean. */
export function LargeWeeks({ weeks, firstOn }: WeeksProps) {
  return (
    <>
      <ul className={`grid gap-3px ${classes.large}`} aria-label="Next 12 weeks">
        {weeks.map((state, place) => (
          <li key={place}>
            <span className={`border-edge rounded-2px bg-surface ${classes.week}`} data-state={state} />
            <span className="visually-hidden">{`Week of ${shortDay(mondayOf(firstOn, place))}: ${WEEK_WORDS[state]}`}</span>
            <span className="micro dim nowrap" aria-hidden="true">
              {place % 4 === 0 ? shortDay(mondayOf(firstOn, place)) : ' '}
            </span>
          </li>
        ))}
      </ul>
      <p className={`small mid flex wrap gap-3 ${classes.legend}`} aria-hidden="true">
        {(Object.keys(WEEK_WORDS) as Week[]).map((state) => (
          <span key={state}>
            <span className={`border-edge rounded-2px bg-surface ${classes.week}`} data-state={state} />
            {WEEK_WORDS[state]}
          </span>
        ))}
      </p>
    </>
  )
}
