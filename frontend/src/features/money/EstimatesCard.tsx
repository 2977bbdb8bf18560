import { useQuery } from '@tanstack/react-query'

import { estimatesQuery } from '@/money/api'
import { Card, CardHead } from '@/ui/Card'
import { day, deviation, figure, plural } from '@/ui/format'

import classes from './Page.module.css'

/** How estimates turn out; for the two parties only. */
export function EstimatesCard({ contractId, title }: { contractId: string; title: string }) {
  const { data } = useQuery(estimatesQuery(contractId))
  if (!data || (data.cues.length === 0 && data.milestones.length === 0)) return null
  const id = `estimates-${contractId}`
  const habits = [
    { name: 'Cues', habit: data.cue_habit },
    { name: 'Milestones', habit: data.milestone_habit },
  ]
  return (
    <Card aria-label={`Estimates, ${title}`}>
      <CardHead id={id} title="Estimates" end="visible to the two of you only" />
      <div className={classes.pad}>
        {habits.map(({ name, habit: { pairs, mean_percent: mean, spread_points: spread } }) => (
          <p key={name} className={classes.line}>
            <span className="mid">{name}</span>
            <span>
              {mean === null || spread === null
                ? 'no finished cues yet'
                : `${deviation(mean)}, spread ${figure(spread)} points, of ${plural(pairs, 'estimate')}`}
            </span>
          </p>
        ))}
        {data.forecasts.map(({ milestone, due_on: due, forecast_on: forecast }) => (
          <p key={milestone} className="small">
            {milestone}:{' '}
            {due === forecast ? 'on time at this rate' : `${day(forecast)} at this rate, agreed ${day(due)}`}.
          </p>
        ))}
        {data.warning !== null && <p className="small tone-warn">{data.warning}</p>}
      </div>
    </Card>
  )
}
