import { useQuery } from '@tanstack/react-query'
import { queryById } from '@/api'
import { Link } from '@tanstack/react-router'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { hours, money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { average, days, duration, figure, plural, share, shortDay } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import { BudgetForm } from './BudgetForm'
import classes from './Pace.module.css'

type Pace = components['schemas']['Pace']

const HOUR_S = 3_600
const FEWER_BY = 0.1 // of the share: less is chance
const HIGH_CHURN = 0.2 // of the ordered cues

const paceQuery = queryById('/v1/projects/{project_id}/pace', queryKeys.pace)

interface Line {
  word: string
  value: string
  /** What both sides had better talk about. */
  warns?: boolean
}

function ofWork(pace: Pace): Line[] {
  const { first_pass: firstPass, first_pass_lately: lately, first_pass_before: before } = pace
  const falls = lately !== null && before !== null && lately < before - FEWER_BY
  const trend = lately !== null && before !== null ? `; ${share(lately)} in four weeks, ${share(before)} before` : ''
  const late = pace.days_late
  const isSlow = pace.finish_on !== null && pace.needed_on !== null && pace.finish_on > pace.needed_on
  return [
    { word: 'Accepted', value: `${figure(pace.accepted)} of ${figure(pace.cues)}` },
    ...(firstPass === null ? [] : [{ word: 'Accepted as first sent', value: share(firstPass) + trend, warns: falls }]),
    ...(pace.rounds_per_cue === null ? [] : [{ word: 'Rounds per cue', value: average(pace.rounds_per_cue) }]),
    ...(late === null
      ? []
      : [
          {
            word: 'Against the due day',
            value: late > 0 ? `${days(late)} late` : late < 0 ? 'early' : 'on time',
            warns: late > 0,
          },
        ]),
    ...(pace.overdue > 0 ? [{ word: 'Overdue', value: plural(pace.overdue, 'cue'), warns: true }] : []),
    ...(pace.finish_on === null
      ? []
      : [
          {
            word: 'Done at this pace',
            value: shortDay(pace.finish_on) + (pace.needed_on ? `; needed by ${shortDay(pace.needed_on)}` : ''),
            warns: isSlow,
          },
        ]),
  ]
}

/** "1 version, for 20 min", "3 versions, the longest for 2 days". */
const waiting = (count: number, noun: string, hours: number) =>
  `${plural(count, noun)}, ${count === 1 ? '' : 'the longest '}for ${duration(hours * HOUR_S)}`

function ofStudio({ studio }: Pace): Line[] {
  const { review_hours: review, answer_hours: answer, days_to_pay: pays } = studio
  const { longest_review_wait_hours: reviewWait, longest_answer_wait_hours: answerWait } = studio
  return [
    ...(review === null ? [] : [{ word: 'Time to a verdict', value: duration(review * HOUR_S) }]),
    ...(reviewWait === null
      ? []
      : [{ word: 'Waiting for a verdict', value: waiting(studio.waiting_reviews, 'version', reviewWait) }]),
    ...(answer === null ? [] : [{ word: 'Time to an answer', value: duration(answer * HOUR_S) }]),
    ...(answerWait === null
      ? []
      : [
          { word: 'Waiting for an answer', value: waiting(studio.open_questions, 'question', answerWait), warns: true },
        ]),
    ...(pays === null ? [] : [{ word: 'Time to pay', value: pays === 0 ? 'the same day' : days(pays) }]),
    ...(studio.late_invoices > 0 ? [{ word: 'Late invoices', value: figure(studio.late_invoices), warns: true }] : []),
  ]
}

type Costs = Pace['costs'][number]

function ofCosts(costs: Costs): Line[] {
  const { currency, budget_minor: budget, committed_minor: committed, per_kept_minor: perKept, churn } = costs
  const format = (minor: number) => money(minor, currency)
  const left = (budget ?? 0) - committed
  return [
    ...(budget === null
      ? []
      : [
          {
            word: 'Budget',
            value: `${format(budget)}; ${left < 0 ? `${format(-left)} over` : `${format(left)} not committed`}`,
            warns: left < 0,
          },
        ]),
    { word: 'Committed', value: format(committed) },
    {
      word: 'Spent',
      value:
        costs.due_minor === 0
          ? format(costs.spent_minor)
          : `${format(costs.spent_minor)}; ${format(costs.due_minor)} due`,
    },
    ...(perKept === null
      ? []
      : [{ word: 'Cost of a kept sound', value: `${format(perKept)}; ${figure(costs.kept)} kept` }]),
    ...(costs.to_finish_minor === 0 ? [] : [{ word: 'Left to accept', value: format(costs.to_finish_minor) }]),
    ...(churn === null
      ? []
      : [
          {
            word: 'Changed after work began',
            value: `${share(churn)}, ${figure(costs.churned)} of ${plural(costs.ordered, 'cue')}; ${format(costs.churned_minor)}`,
            warns: churn > HIGH_CHURN,
          },
        ]),
  ]
}

function ofEstimates({ estimates, over_estimate: over }: Pace): Line[] {
  const overrun = over && {
    word: 'Over estimate already',
    value: `${plural(over.cues, 'open cue')} by ${hours(over.over_min)}`,
    warns: true,
  }
  if (estimates === null) return overrun ? [overrun] : []
  const { error_percent: error, estimated_min: estimated, logged_min: logged, cues } = estimates
  const off = share(Math.abs(error) / 100)
  return [
    {
      word: 'Against estimates',
      value: error === 0 ? 'as estimated' : `${off} ${error > 0 ? 'longer' : 'shorter'}`,
    },
    { word: 'Logged, estimated', value: `${hours(logged)}, ${hours(estimated)}; ${plural(cues, 'cue')}` },
    ...(overrun ? [overrun] : []),
  ]
}

/** Early warning, the same for both sides: how the work goes, and how the studio does its own part. */
export function PaceCard({ projectId, isProducer }: { projectId: string; isProducer: boolean }) {
  const { data: pace, error } = useQuery(paceQuery(projectId))
  return (
    <Card aria-labelledby="pace">
      <CardHead
        id="pace"
        title="Pace"
        note={isProducer ? 'both sides see this, but for the budget' : 'both sides see this'}
      />
      <Refusal inset error={error} />
      {pace && (
        <div className={`grid gap-4 p-3-4-4 ${classes.parts}`}>
          <Part head="The work" lines={ofWork(pace)} />
          <Part head="The studio’s part" lines={ofStudio(pace)} />
          {pace.costs.map((costs) => (
            <Part key={costs.currency} head={`Money in ${costs.currency}`} lines={ofCosts(costs)} />
          ))}
          <Part head="Estimates" lines={ofEstimates(pace)} />
          {pace.worn.length > 0 && (
            <section className="col-span-full" aria-label="Cues with many rounds">
              <h3 className="small mid">Three rounds or more, not accepted</h3>
              <ul>
                {pace.worn.map(({ cue_id, label, name, rounds }) => (
                  <li key={cue_id}>
                    <Link
                      className="link"
                      to="/projects/$projectId/sound-list/cues/$cueId"
                      params={{ projectId, cueId: cue_id }}
                    >
                      {label} {name}
                    </Link>{' '}
                    <span className="mid">{plural(rounds, 'round')}</span>
                  </li>
                ))}
              </ul>
              <p className="small dim">Talk before another round: the brief may be unclear, or the price too low.</p>
            </section>
          )}
          {isProducer && <BudgetForm projectId={projectId} currencies={pace.costs.map(({ currency }) => currency)} />}
        </div>
      )}
    </Card>
  )
}

function Part({ head, lines }: { head: string; lines: readonly Line[] }) {
  if (lines.length === 0) return null
  return (
    <section>
      <h3 className="small mid">{head}</h3>
      <dl className={`grid gap-3px mt-1 ${classes.pairs}`}>
        {lines.map(({ word, value, warns }) => (
          <div key={word}>
            <dt>{word}</dt>
            <dd className={warns ? 'tone-warn toned' : undefined}>
              {warns && <Icon name="triangle" />} {value}
            </dd>
          </div>
        ))}
      </dl>
    </section>
  )
}
