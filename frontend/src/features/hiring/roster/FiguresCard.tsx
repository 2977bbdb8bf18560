import { Link } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'
import { figure, plural } from '@/ui/format'

import forms from '../Hiring.module.css'
import type { Figures } from './api'
import classes from './Roster.module.css'

const DAY_HOURS = 24
const HABITS = { unknown: 'too few to say', steady: 'steady', wild: 'differs much from one to the next' } as const

const percent = (share: number) => `${figure(share * 100)} %`
const took = (hours: number) =>
  hours < 2 * DAY_HOURS ? plural(Math.max(1, Math.round(hours)), 'hour') : plural(Math.round(hours / DAY_HOURS), 'day')

/** What is known; figures of fewer than three cases are left out by the server. */
function linesOf(figures: Figures): [word: string, value: string][] {
  const { on_time: onTime, days_late: late, first_pass: first, rounds_per_cue: rounds } = figures
  const { revision_hours: revision, estimates } = figures
  const lines: [string, string][] = [['Accepted cues', figure(figures.accepted)]]
  if (onTime !== null) lines.push(['Accepted on time', percent(onTime)])
  if (late !== null && late > 0) lines.push(['Typically late by', plural(Math.round(late), 'day')])
  if (first !== null) lines.push(['Accepted as first sent', percent(first)])
  if (rounds !== null) lines.push(['Rounds per cue', figure(rounds, 1)])
  if (revision !== null) lines.push(['From changes to the next version', took(revision)])
  if (estimates !== null && estimates.mean_percent !== null) {
    const { mean_percent: error, pairs, habit } = estimates
    const sign = error >= 0 ? '+' : '−'
    const size = `${sign}${figure(Math.abs(error))} % over ${plural(pairs, 'cue')}`
    lines.push(['Work against estimates', `${size}, ${HABITS[habit]}`])
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
      <div className={forms.body}>
        <dl className={classes.facts}>
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
