import { Link } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'
import { average, days, deviation, duration, figure, plural, share } from '@/ui/format'

import forms from '../Hiring.module.css'
import type { Figures } from './api'
import classes from './Roster.module.css'

const HOUR_S = 3_600
const HABITS = { unknown: 'too few to say', steady: 'steady', wild: 'differs much from one to the next' } as const

/** What is known; figures of fewer than three cases are left out by the server. */
function linesOf(figures: Figures): [word: string, value: string][] {
  const { on_time: onTime, days_late: late, first_pass: first, rounds_per_cue: rounds } = figures
  const { revision_hours: revision, estimates } = figures
  const lines: [string, string][] = [['Accepted cues', figure(figures.accepted)]]
  if (onTime !== null) lines.push(['Accepted on time', share(onTime)])
  if (late !== null && late > 0) lines.push(['Typically late by', days(late)])
  if (first !== null) lines.push(['Accepted as first sent', share(first)])
  if (rounds !== null) lines.push(['Rounds per cue', average(rounds)])
  if (revision !== null) lines.push(['From changes to the next version', duration(revision * HOUR_S)])
  if (estimates !== null && estimates.mean_percent !== null) {
    const { mean_percent: error, pairs, habit } = estimates
    lines.push(['Work against estimates', `${deviation(error)} over ${plural(pairs, 'cue')}, ${HABITS[habit]}`])
  }
  return lines
}

interface FiguresCardProps {
  figures: Figures
  title: string
  note?: string
  /** The reader can open every project that is named. */
  linksProjects?: boolean
}

/** What is known of a designer from work for one studio: computed, never typed. */
export function FiguresCard({ figures, title, note, linksProjects = false }: FiguresCardProps) {
  const id = `work-${figures.studio_id}`
  const isFew = figures.first_pass === null
  return (
    <Card aria-labelledby={id}>
      <CardHead id={id} title={title} note={note} />
      <div className={`grid gap-3 ${forms.body}`}>
        <dl className={`grid ${classes.facts}`}>
          {linesOf(figures).map(([word, value]) => (
            <div key={word} style={{ display: 'contents' }}>
              <dt className="mid">{word}</dt>
              <dd>{value}</dd>
            </div>
          ))}
          <dt className="mid">Projects</dt>
          <dd>
            {figures.projects.map(({ id: projectId, name, accepted }, at) => (
              <span key={projectId}>
                {at > 0 && ', '}
                {linksProjects ? (
                  <Link className="link" to="/projects/$projectId" params={{ projectId }}>
                    {name}
                  </Link>
                ) : (
                  name
                )}
                {` (${accepted} accepted)`}
              </span>
            ))}
          </dd>
        </dl>
        {isFew && <p className="small dim">Further figures appear after three decided cues.</p>}
      </div>
    </Card>
  )
}
