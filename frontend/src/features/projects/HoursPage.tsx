import { queryOptions, useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { answered, api } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { useTitle } from '@/app/title'
import { hours as inHours } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { figure, plural, shortDay } from '@/ui/format'

import classes from './Hours.module.css'

type Schemas = components['schemas']
type Hours = Schemas['ProjectHours']
type Designer = Schemas['DesignerHours']
type Sum = Schemas['HoursSum']
type Week = Schemas['WeekHours']

const hoursQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.hours(projectId),
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/hours', { params: { path: { project_id: projectId } } })),
  })

const hours = (value: number): string => inHours(value > 0 ? Math.max(1, Math.round(value * 60)) : 0)

/** "12 h left, 3 h done; 4 cues without an estimate". */
function sumWords({ left_h: left, done_h: done, unknown }: Sum): string {
  const known = `${hours(left)} left, ${hours(done)} logged`
  return unknown === 0 ? known : `${known}; ${plural(unknown, 'cue')} without an estimate`
}

/** Hours of agreed work: what is due by when, against the hours that designers say they have. */
export function HoursPage() {
  useTitle('Hours')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/hours' })
  const { data, error } = useQuery(hoursQuery(projectId))
  return (
    <div className="page stack" aria-busy={!data && error === null}>
      <div>
        <h1>Hours</h1>
        <p className="mid">
          Estimates of the cues under contract that are not accepted yet, by the week in which they are due, against the
          hours a week and the booked days on the{' '}
          <Link className="link" to="/roster">
            roster
          </Link>
          . What is not known is counted, and nothing is guessed for it.
        </p>
      </div>
      <Refusal inset error={error} />
      {data && <Shown data={data} projectId={projectId} />}
    </div>
  )
}

function Shown({ data, projectId }: { data: Hours; projectId: string }) {
  if (data.designers.length === 0) {
    return (
      <EmptyState head="No agreed work is open">
        {data.uncontracted > 0
          ? `${plural(data.uncontracted, 'cue of the list is', 'cues of the list are')} under no agreed contract, so ${data.uncontracted === 1 ? 'its' : 'their'} hours are not known. `
          : ''}
        Hours come from the estimates in the plan of a contract:{' '}
        <Link className="link" to="/projects/$projectId/contracts" params={{ projectId }}>
          contracts
        </Link>
        .
      </EmptyState>
    )
  }
  return (
    <>
      {data.designers.map((designer) => (
        <DesignerCard key={designer.designer.id} designer={designer} />
      ))}
      <Card aria-labelledby="categories">
        <CardHead id="categories" title="By category" note={sumWords(data.total)} />
        {/* Wide tables scroll by themselves; the focus lets the arrow keys do it. */}
        {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
        <section className={classes.scroll} aria-label="Hours by category" tabIndex={0}>
          <table className={classes.table}>
            <thead>
              <tr>
                <th scope="col">Category</th>
                <th scope="col" className="num">
                  Cues
                </th>
                <th scope="col" className="num">
                  Left
                </th>
                <th scope="col" className="num">
                  Logged
                </th>
                <th scope="col" className="num">
                  Without an estimate
                </th>
              </tr>
            </thead>
            <tbody>
              {data.categories.map((one) => (
                <tr key={one.category}>
                  <th scope="row">{one.category || 'No category'}</th>
                  <td className="num">{figure(one.cues)}</td>
                  <td className="num">{hours(one.left_h)}</td>
                  <td className="num">{hours(one.done_h)}</td>
                  <td className="num">{one.unknown > 0 ? figure(one.unknown) : ''}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </section>
        {data.uncontracted > 0 && (
          <p className={`${classes.note} small mid`}>
            {`${plural(data.uncontracted, 'cue')} of the list ${data.uncontracted === 1 ? 'is' : 'are'} under no agreed contract: hours not known.`}
          </p>
        )}
      </Card>
    </>
  )
}

function DesignerCard({ designer }: { designer: Designer }) {
  const { designer: person, weeks, weekly_hours: weekly, roster_entry_id: entryId, undated } = designer
  const short = weeks.find(({ is_short: isShort }) => isShort)
  const most = Math.max(1, ...weeks.map(({ wanted_h: wanted, there_h: there }) => Math.max(wanted, there ?? 0)))
  return (
    <Card aria-labelledby={`hours-${person.id}`}>
      <CardHead id={`hours-${person.id}`} title={person.name} note={sumWords(designer)} />
      <div className={classes.note}>
        <p className={short ? 'tone-warn' : 'mid'}>
          <span className={short ? 'toned' : undefined}>
            {short
              ? `By the end of the week of ${shortDay(short.week_on)}: ${hours(short.wanted_h)} due, ${hours(short.there_h ?? 0)} there.`
              : weekly === null
                ? 'Hours a week are not known, so nothing can be held against what is due.'
                : `What is due fits into ${hours(weekly)} a week and the days that are free.`}
          </span>{' '}
          {weekly === null && (
            <Link className="link" to={entryId ? '/roster/$entryId' : '/roster'} params={{ entryId: entryId ?? '' }}>
              {entryId ? 'Enter the hours a week' : 'Put this designer on file'}
            </Link>
          )}
        </p>
        {undated > 0 && (
          <p className="small mid">{`${plural(undated, 'cue')} without a day ${undated === 1 ? 'is' : 'are'} in no week.`}</p>
        )}
      </div>
      {/* Wide tables scroll by themselves; the focus lets the arrow keys do it. */}
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
      <section className={classes.scroll} aria-label={`Weeks of ${person.name}`} tabIndex={0}>
        <table className={classes.table}>
          <thead>
            <tr>
              <th scope="col">Week of</th>
              <th scope="col" className="num">
                Due in it
              </th>
              <th scope="col" className="num">
                Due by then
              </th>
              <th scope="col" className="num">
                There by then
              </th>
              <th scope="col">
                <span className="visually-hidden">Due against there</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {weeks.map((week) => (
              <tr key={week.week_on}>
                <th scope="row">{shortDay(week.week_on)}</th>
                <td className="num">{week.due_h > 0 ? hours(week.due_h) : ''}</td>
                <td className="num">{hours(week.wanted_h)}</td>
                <td className="num">{week.there_h === null ? 'not known' : hours(week.there_h)}</td>
                <td className={classes.gauge}>
                  <Gauge week={week} most={most} />
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
    </Card>
  )
}

/** A frame as long as the hours there, filled by the hours due; where more is due it stands out of the frame. */
function Gauge({ week, most }: { week: Week; most: number }) {
  const there = week.there_h
  const words = there === null ? 'hours there not known' : week.is_short ? 'more is due than there is' : 'it fits'
  return (
    <span className={classes.bar} role="img" aria-label={words}>
      <i
        className={week.is_short ? `${classes.due} ${classes.over}` : classes.due}
        style={{ width: `${(week.wanted_h / most) * 100}%` }}
      />
      {there !== null && <i className={classes.frame} style={{ width: `${(there / most) * 100}%` }} />}
    </span>
  )
}
