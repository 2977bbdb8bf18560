import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { ciQuery } from '@/api/project'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'

import { type BuildBrief, type Project } from './api'
import { BuildLine, BuildReasons } from './BuildLines'
import classes from './Builds.module.css'
import { CopyLines } from './CiLines'
import { outcomeOf, outcomesInWords } from './reports'
import { TokenMaker } from './Tokens'

const FILES = 4
const LINES = 4

interface BuildsCardProps {
  project: Project
  builds: readonly BuildBrief[]
}

/** What the game's CI said of the last builds, the latest with its reasons, and what a build runs. */
export function BuildsCard({ project: { id: projectId, mine }, builds }: BuildsCardProps) {
  const [latest, ...earlier] = builds
  const all = (
    <>
      <Link className="link" to="/projects/$projectId/drift" params={{ projectId }}>
        Levels
      </Link>
      <Link className="link" to="/projects/$projectId/builds" params={{ projectId }}>
        {builds.length > 0 ? 'All' : 'Builds'}
        {builds.length > 0 && <span className="visually-hidden"> builds</span>}
      </Link>
    </>
  )
  return (
    <Card aria-labelledby="builds">
      <CardHead
        id="builds"
        title="Builds"
        note={builds.length > 1 ? `last ${builds.length}: ${outcomesInWords(builds)}` : undefined}
        end={all}
      />
      {latest ? (
        <>
          <div className={`border-b ${classes.squares}`}>
            <Squares builds={builds} />
          </div>
          <BuildLine build={latest}>
            <div className="col-span-full mt-6px">
              <BuildReasons build={latest} projectId={projectId} most={FILES} />
            </div>
          </BuildLine>
          {earlier.slice(0, LINES - 1).map((build) => (
            <BuildLine key={build.id} build={build} />
          ))}
        </>
      ) : (
        <div className={classes.inside}>
          <EmptyState head="No builds yet" level={3}>
            The game’s CI checks its audio with the same spec and list. It needs a token and the commands below.
          </EmptyState>
        </div>
      )}
      <CiLines projectId={projectId} />
      {latest && (
        <p className={`small dim ${classes.foot}`}>
          {`${plural(latest.files, 'file')} checked in build ${latest.label}, with the same rules as uploads.`}
        </p>
      )}
      {mine.is_producer && (
        <div className={classes.foot}>
          <TokenMaker projectId={projectId} />
        </div>
      )}
    </Card>
  )
}

/** One square a build, the oldest first; height and colour say how it ended, and words do for those who listen. */
function Squares({ builds }: { builds: readonly BuildBrief[] }) {
  return (
    <div
      className={`flex items-end gap-3px ${classes.run}`}
      role="img"
      aria-label={`${plural(builds.length, 'build')}: ${outcomesInWords(builds)}`}
    >
      {builds.toReversed().map((build) => (
        <i key={build.id} data-outcome={outcomeOf(build)} title={build.label} />
      ))}
    </div>
  )
}

/** The line that the game's CI runs, to see and to take. */
function CiLines({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(ciQuery(projectId))
  if (error) return <Refusal inset error={error} />
  if (data === undefined) return null
  return (
    <div className={`row bg-well inset border rounded ${classes.command}`}>
      <code>{data.command.replace(/ (&&|--server|--project|--target)/g, ' \\\n  $1')}</code>
      <div className={`grid ${classes.take}`}>
        <CopyLines lines={[data.command]} label="Copy the CI command" />
        <Link
          className="link small"
          to="/projects/$projectId/builds"
          params={{ projectId }}
          aria-label="Show the steps of the CI command"
        >
          Steps
        </Link>
      </div>
    </div>
  )
}
