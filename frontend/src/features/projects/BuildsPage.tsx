import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { ShowMore } from '@/ui/ShowMore'

import { type Build, useBuilds } from './api'
import { BuildLine, BuildReasons } from './BuildLines'
import classes from './Builds.module.css'
import { CiCard } from './CiLines'

/** Every build that reported, and the steps by which a CI reports. */
export function BuildsPage() {
  useTitle('Builds')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/builds' })
  const { data: project } = useQuery(projectQuery(projectId))
  const pages = useBuilds(projectId)
  const { data, error } = pages
  const builds = data?.pages.flatMap(({ items }) => items)
  return (
    <div className="page stack">
      <div>
        <h1>Builds</h1>
        <p className="mid">
          Audio checks run by the game’s CI, with the spec and list of{' '}
          <Link className="link" to="/projects/$projectId" params={{ projectId }}>
            the project
          </Link>
          .
        </p>
        <p>
          <Link className="link" to="/projects/$projectId/drift" params={{ projectId }}>
            In-game levels
          </Link>
          <span className="mid">: how each build plays the approved sounds, drift, and the listening pass.</span>
        </p>
      </div>
      <Refusal inset error={error} />
      <div className={`columns ${classes.columns}`}>
        <Card aria-labelledby="all-builds">
          <CardHead id="all-builds" title="Builds" note="newest first" />
          {builds?.length === 0 && (
            <div className={classes.inside}>
              <EmptyState head="No builds yet" level={3}>
                Create a token, add it to the CI’s secrets, and add the commands to the build.
              </EmptyState>
            </div>
          )}
          {builds?.map((build, index) => (
            <OneBuild key={build.id} build={build} projectId={projectId} opened={index === 0} />
          ))}
          {pages.hasNextPage && (
            <div className={classes.inside}>
              <ShowMore list={pages}>Earlier builds</ShowMore>
            </div>
          )}
        </Card>
        <div className="stack">
          {project?.mine.is_producer && (
            <p className="mid">
              The CI signs in with a token.{' '}
              <Link className="link" to="/projects/$projectId/tokens" params={{ projectId }}>
                Tokens
              </Link>
            </p>
          )}
          <CiCard projectId={projectId} />
        </div>
      </div>
    </div>
  )
}

function OneBuild({ build, projectId, opened }: { build: Build; projectId: string; opened: boolean }) {
  const [open, setOpen] = useState(opened)
  return (
    <details open={open} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary className={`hover pointer ${classes.summary}`}>
        <BuildLine build={build} />
      </summary>
      {open && (
        <div className="border-b p-2-inset-3">
          <BuildReasons build={build} projectId={projectId} />
        </div>
      )}
    </details>
  )
}
