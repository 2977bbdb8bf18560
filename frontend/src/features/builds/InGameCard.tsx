import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { countOf, figure, plural } from '@/ui/format'

import { type CueInGame, gameStatesQuery, useMarkCue } from './api'
import classes from './Drift.module.css'

/** How much of the list is in the build, how much was heard in the game, and what never was. */
export function InGameCard({ projectId }: { projectId: string }) {
  const { data } = useQuery(gameStatesQuery(projectId))
  const mark = useMarkCue(projectId)
  if (data === undefined) return null
  return (
    <Card aria-labelledby="in-game">
      <CardHead
        id="in-game"
        title="In the game"
        note={`${figure(data.in_build)} of ${plural(data.cues, 'cue')} in the build`}
      />
      <div className="grid gap-2 p-3-inset">
        <p>
          <span className="figure">{figure(data.heard)}</span>{' '}
          <span className="mid">{`of ${figure(data.cues)} heard in the game`}</span>
        </p>
        <Bar part={data.heard} whole={data.cues} label="Heard in the game" />
        <p className="small strong">{`Never heard in the game: ${figure(data.never_heard)}`}</p>
      </div>
      <ul>
        {data.categories.map(({ category, cues, heard }) => (
          <li key={category} className={`grid items-center gap-3 border-t ${classes.category}`}>
            <span className="cut-text">{category || 'Without a category'}</span>
            <Bar part={heard} whole={cues} label={category || 'Without a category'} />
            <span className="num">{countOf(heard, cues)}</span>
          </li>
        ))}
      </ul>
      {data.unheard.length > 0 && (
        <details className="border-t p-2-inset">
          <summary className="pointer min-h-24px">
            {data.unheard.length < data.never_heard
              ? `The first ${data.unheard.length} of them`
              : plural(data.unheard.length, 'cue')}{' '}
            never heard
          </summary>
          <ul className="small">
            {data.unheard.map((row) => (
              <Unheard key={row.cue.id} row={row} mayMark={data.may_mark} onMark={mark.mutate} />
            ))}
          </ul>
        </details>
      )}
      <Refusal error={mark.error} />
      <div className="grid gap-2 p-3-inset">
        <ButtonLink component={Link} to={`/projects/${projectId}/listening`} icon="headphones">
          Listening pass
        </ButtonLink>
      </div>
    </Card>
  )
}

function Bar({ part, whole, label }: { part: number; whole: number; label: string }) {
  return (
    <span className={`block ${classes.bar2}`} role="img" aria-label={`${label}: ${countOf(part, whole)}`}>
      <i style={{ width: `${whole === 0 ? 0 : (part / whole) * 100}%` }} data-whole={part === whole || undefined} />
    </span>
  )
}

interface UnheardProps {
  row: CueInGame
  mayMark: boolean
  onMark: ReturnType<typeof useMarkCue>['mutate']
}

function Unheard({ row: { cue, in_build: inBuild }, mayMark, onMark }: UnheardProps) {
  const where = inBuild === null ? 'not in the build' : inBuild === 'hand' ? 'in the build, by hand' : 'in the build'
  return (
    <li className="row wrap between">
      <span>
        {cue.name} <span className="dim">{where}</span>
      </span>
      {mayMark && (
        <span className="row">
          {inBuild !== 'audit' && (
            <Button
              variant="quiet"
              aria-label={`${cue.name}: ${inBuild === 'hand' ? 'not in the build' : 'in the build'}`}
              onClick={() => onMark({ cueId: cue.id, mark: 'in-build', isSet: inBuild === null })}
            >
              {inBuild === 'hand' ? 'Not in the build' : 'In the build'}
            </Button>
          )}
          <Button
            variant="quiet"
            aria-label={`${cue.name}: heard in the game`}
            onClick={() => onMark({ cueId: cue.id, mark: 'heard', isSet: true })}
          >
            Heard
          </Button>
        </span>
      )}
    </li>
  )
}
