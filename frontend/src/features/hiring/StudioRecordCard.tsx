import { useQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'
import { average, duration, plural } from '@/ui/format'

import { studioRecordQuery } from './api'
import classes from './Hiring.module.css'

const HOUR_S = 3600
const DAY_S = 24 * HOUR_S

/** How the studio reviewed, answered and paid so far. */
export function StudioRecordCard({ postingId }: { postingId: string }) {
  const { data: record } = useQuery(studioRecordQuery(postingId))
  if (!record) return null
  const { review_hours: review, answer_hours: answer, days_to_pay: pays, rounds_per_cue: rounds } = record
  const { bonuses_promised: promised, bonuses_earned: earned, bonuses_paid: paid } = record
  const facts = [
    review !== null && `Time to a verdict: ${duration(review * HOUR_S)}`,
    answer !== null && `Time to an answer: ${duration(answer * HOUR_S)}`,
    pays !== null && `Time to a payment: ${duration(pays * DAY_S)}`,
    rounds !== null && `Rounds of changes for a cue: ${average(rounds)}`,
    promised > 0 && `Bonuses: ${plural(promised, 'contract')} with one, ${earned} earned, ${paid} paid`,
  ].filter((fact) => fact !== false)
  return (
    <Card aria-labelledby="studio-record">
      <CardHead id="studio-record" title={`${record.studio_name}’s record`} end="medians over its projects here" />
      <div className={`grid gap-3 ${classes.body}`}>
        {facts.length === 0 ? (
          <p className="mid">Too little has happened here yet to say how fast the studio reviews, answers and pays.</p>
        ) : (
          <ul>
            {facts.map((fact) => (
              <li key={fact}>{fact}.</li>
            ))}
          </ul>
        )}
      </div>
    </Card>
  )
}
