import { useQuery } from '@tanstack/react-query'

import type { components } from '@/api/schema.gen'
import { estimatesQuery } from '@/money/api'
import { hours, money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { day, deviation, figure, plural } from '@/ui/format'

/** How estimates turn out; for the two parties only. */
export function EstimatesCard({ contractId, title }: { contractId: string; title: string }) {
  const { data } = useQuery(estimatesQuery(contractId))
  if (!data || (data.cues.length === 0 && data.milestones.length === 0 && !data.pay)) return null
  const id = `estimates-${contractId}`
  const habits = [
    { name: 'Cues', habit: data.cue_habit },
    { name: 'Milestones', habit: data.milestone_habit },
  ]
  return (
    <Card aria-label={`Estimates, ${title}`}>
      <CardHead id={id} title="Estimates" end="visible to the two of you only" />
      <div className="p-3-inset">
        {habits.map(({ name, habit: { pairs, mean_percent: mean, spread_points: spread } }) => (
          <p key={name} className="grid grid-cols-1-auto gap-0-3">
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
        {data.pay && <PayLines pay={data.pay} />}
        {data.warning !== null && <p className="small tone-warn">{data.warning}</p>}
      </div>
    </Card>
  )
}

/** What an hour earns; the designer alone is told. */
function PayLines({ pay }: { pay: NonNullable<components['schemas']['EstimatesRead']['pay']> }) {
  const { currency, estimated_min, logged_min, own_min, by_estimate_minor, by_log_minor } = pay
  const ownTime = own_min > 0 ? `, ${hours(own_min)} of it without the contract` : ''
  return [
    { name: 'An hour earns, as estimated', minutes: estimated_min, minor: by_estimate_minor, more: '' },
    { name: 'An hour earns, as logged', minutes: logged_min, minor: by_log_minor, more: ownTime },
  ].map(
    ({ name, minutes, minor, more }) =>
      minor !== null && (
        <p key={name} className="grid grid-cols-1-auto gap-0-3">
          <span className="mid">{name}</span>
          <span>{`${money(minor, currency)}, of ${hours(minutes)}${more}`}</span>
        </p>
      ),
  )
}
