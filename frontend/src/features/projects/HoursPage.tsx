import { useQuery } from '@tanstack/react-query'
import { queryById } from '@/api'
import { Link, useParams } from '@tanstack/react-router'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { useTitle } from '@/app/title'
import { hours as inHours } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { figure, plural, shortDay } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Table } from '@/ui/Table'

import classes from './Hours.module.css'

type Schemas = components['schemas']
type Hours = Schemas['ProjectHours']
type Designer = Schemas['DesignerHours']
type Sum = Schemas['HoursSum']
type Week = Schemas['WeekHours']

const hoursQuery = queryById('/v1/projects/{project_id}/hours', queryKeys.hours)

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
      <PageHead title="Hours">
        Estimates of the cues under contract that are not accepted yet, by the week in which they are due, against the
        hours a week and the booked days on the{' '}
        <Link className="link" to="/roster">
          roster
        </Link>
        . What is not known is counted, and nothing is guessed for it.
      </PageHead>
      <Refusal inset error={error} />
      {data && <Shown data={data} projectId={projectId} />}
    </div>
  )
}

function Shown({ data, projectId }: { data: Hours; projectId: string }) {
  if (data.designers.length === 0) {
    return (
      <EmptyState head="No open contracted work">
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
        <Table
          label="Hours by category"
          rows={data.categories}
          keyOf={({ category }) => category}
          columns={[
            { head: 'Category', rowHead: true, cell: ({ category }) => category || 'No category' },
            { head: 'Cues', numeric: true, cell: ({ cues }) => figure(cues) },
            { head: 'Left', numeric: true, cell: ({ left_h: left }) => hours(left) },
            { head: 'Logged', numeric: true, cell: ({ done_h: done }) => hours(done) },
            { head: 'Without an estimate', numeric: true, cell: ({ unknown }) => (unknown > 0 ? figure(unknown) : '') },
          ]}
        />
        {data.uncontracted > 0 && (
          <p className="p-2-inset small mid">
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
  const most = Math.max(1, ...weeks.map(({ wanted_h: wantedH, there_h: there }) => Math.max(wantedH, there ?? 0)))
  return (
    <Card aria-labelledby={`hours-${person.id}`}>
      <CardHead id={`hours-${person.id}`} title={person.name} note={sumWords(designer)} />
      <div className="p-2-inset">
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
      <Table
        label={`Weeks of ${person.name}`}
        rows={weeks}
        keyOf={({ week_on: on }) => on}
        columns={[
          { head: 'Week of', rowHead: true, cell: ({ week_on: on }) => shortDay(on) },
          { head: 'Due in it', numeric: true, cell: ({ due_h: due }) => (due > 0 ? hours(due) : '') },
          { head: 'Due by then', numeric: true, cell: ({ wanted_h: due }) => hours(due) },
          {
            head: 'There by then',
            numeric: true,
            cell: ({ there_h: there }) => (there === null ? 'not known' : hours(there)),
          },
          {
            head: <span className="visually-hidden">Due against there</span>,
            className: classes.gauge,
            cell: (week) => <Gauge week={week} most={most} />,
          },
        ]}
      />
    </Card>
  )
}

/** A frame as long as the hours there, filled by the hours due; where more is due it stands out of the frame. */
function Gauge({ week, most }: { week: Week; most: number }) {
  const there = week.there_h
  const words = there === null ? 'hours there not known' : week.is_short ? 'more is due than there is' : 'it fits'
  return (
    <span className={`block relative ${classes.bar}`} role="img" aria-label={words}>
      <i
        className={week.is_short ? `${classes.due} ${classes.over}` : classes.due}
        style={{ width: `${(week.wanted_h / most) * 100}%` }}
      />
      {there !== null && <i className={`border-edge ${classes.frame}`} style={{ width: `${(there / most) * 100}%` }} />}
    </span>
  )
}
