import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { figure, plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'

import { type Countdown, countdownQuery } from './api'
import classes from './Project.module.css'

/** What the game still plays a placeholder-file for: how much is left, where, and what to record next. */
export function PlaceholdersCard({ projectId }: { projectId: string }) {
  const { data: countdown, error } = useQuery(countdownQuery(projectId))
  if (error instanceof ApiProblem && error.code === 'target-unknown') return null // the pack says so
  return (
    <Card aria-labelledby="placeholders">
      <CardHead
        id="placeholders"
        title="Placeholders"
        note={countdown && headOf(countdown)}
        end={
          <Link className="link" to="/projects/$projectId/placeholders" params={{ projectId }} search={{}}>
            All placeholders<span className="visually-hidden"> and their files</span>
          </Link>
        }
      />
      <Refusal inset error={error} />
      {countdown && countdown.files > 0 && <Counted projectId={projectId} countdown={countdown} />}
    </Card>
  )
}

function headOf({ cues, cues_left }: Countdown): string {
  if (cues === 0) return 'the sound list is empty'
  if (cues_left === 0) return 'none: every cue is accepted'
  return `${cues_left} of ${plural(cues, 'cue')} without an accepted sound`
}

function Counted({ projectId, countdown }: { projectId: string; countdown: Countdown }) {
  const { files, left, categories, next } = countdown
  return (
    <div className={`grid gap-2 wrap-anywhere p-3-4 ${classes.counted}`}>
      <Meter
        label={`${figure(files - left)} of ${plural(files, 'file')} ${files - left === 1 ? 'has' : 'have'} an accepted sound`}
        whole={files}
        parts={[{ value: files - left, tone: 'ok' }]}
      />
      <ul aria-label="Placeholders by category">
        {categories
          .filter(({ left: open }) => open > 0)
          .map(({ category, files: all, left: open }) => (
            <li key={category} className="row small">
              <span className="grow">{category || 'without a category'}</span>
              <span className="mid">{`${figure(open)} of ${plural(all, 'file')}`}</span>
            </li>
          ))}
      </ul>
      {next ? (
        <p>
          <span className="mid">Next to record: </span>
          <Link
            className="link strong"
            to="/projects/$projectId/sound-list/cues/$cueId"
            params={{ projectId, cueId: next.cue_id }}
          >
            {next.name}
          </Link>{' '}
          <span className="mono small dim">{next.cue}</span> <span className="mono small mid">{next.path}</span>
        </p>
      ) : (
        left > 0 && <p className="mid">All remaining cues have a version in progress.</p>
      )}
    </div>
  )
}
