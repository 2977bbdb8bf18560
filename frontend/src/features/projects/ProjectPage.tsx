import { useQuery } from '@tanstack/react-query'
import { useNavigate, useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { projectQuery } from '@/api/project'
import { useHotkeys } from '@/app/keys'
import { useCommands } from '@/app/palette'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { Refusal } from '@/ui/Refusal'

import { overviewQuery } from './api'
import { BuildsCard } from './BuildsCard'
import { CalendarCard } from './CalendarCard'
import { HandoverCard } from './HandoverCard'
import { LatelyCard } from './LatelyCard'
import { PaceCard } from './PaceCard'
import { PackCard } from './PackCard'
import { PaletteCard } from './PaletteCard'
import classes from './Project.module.css'
import { PlaceholdersCard } from './PlaceholdersCard'
import { PlaylistsCard } from './PlaylistsCard'
import { ProjectHead } from './ProjectHead'
import { SpecCard } from './spec/SpecCard'
import { StepsCard } from './StepsCard'
import { speaks } from './words'

/** A project at one glance: where every cue stands, what a file must be, what the builds said, what can be fetched. */
export function ProjectPage() {
  useTitle('Project')
  const { projectId } = useParams({ from: '/shell/projects/$projectId' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const { data: overview, error: noOverview } = useQuery(overviewQuery(projectId))
  const navigate = useNavigate()
  const maySpeak = project !== undefined && speaks(project)
  const isTeam = project?.mine.is_team ?? false
  const openSpec = () => void navigate({ to: '/projects/$projectId/spec', params: { projectId } })
  useHotkeys(maySpeak ? [{ keys: 'e', label: 'Edit delivery spec', group: 'Project', run: openSpec }] : [])
  useCommands([
    ...(maySpeak
      ? [{ id: 'spec', label: 'Edit delivery spec', icon: 'pencil' as const, keys: 'e', run: openSpec }]
      : []),
    ...(isTeam
      ? [
          {
            id: 'people',
            label: 'People and invitations',
            icon: 'people' as const,
            also: ['invite a designer', 'approver', 'liaison'],
            run: () => void navigate({ to: '/projects/$projectId/people', params: { projectId } }),
          },
          {
            id: 'game-files',
            label: 'Game files, targets and memory',
            icon: 'box' as const,
            also: ['batch', 'render', 'budget'],
            run: () => void navigate({ to: '/projects/$projectId/game-files', params: { projectId } }),
          },
          {
            id: 'packs',
            label: 'Packs',
            icon: 'box' as const,
            also: ['seal', 'release'],
            run: () => void navigate({ to: '/projects/$projectId/packs', params: { projectId } }),
          },
          {
            id: 'placeholders',
            label: 'Placeholders',
            icon: 'dashedSquare' as const,
            also: ['placeholder-file'],
            run: () => void navigate({ to: '/projects/$projectId/placeholders', params: { projectId }, search: {} }),
          },
          {
            id: 'builds',
            label: 'Builds and tokens',
            icon: 'box' as const,
            also: ['CI', 'key'],
            run: () => void navigate({ to: '/projects/$projectId/builds', params: { projectId } }),
          },
        ]
      : []),
    ...(maySpeak || (project && !isTeam)
      ? [
          {
            id: 'money',
            label: 'Money: milestones, invoices, ledger',
            icon: 'lines' as const,
            also: ['payment', 'refund', 'owed'],
            run: () => void navigate({ href: `/projects/${projectId}/money` }),
          },
        ]
      : []),
    {
      id: 'deliveries',
      label: 'Deliveries, open and closed',
      icon: 'tray' as const,
      run: () => void navigate({ to: '/projects/$projectId/deliveries', params: { projectId } }),
    },
    {
      id: 'reasons',
      label: 'Reasons of verdicts',
      icon: 'lines' as const,
      also: ['why', 'approved because'],
      run: () => void navigate({ to: '/projects/$projectId/reasons', params: { projectId }, search: {} }),
    },
    {
      id: 'spec-versions',
      label: 'Versions of the delivery spec',
      icon: 'file' as const,
      run: () => void navigate({ to: '/projects/$projectId/spec/versions', params: { projectId }, search: {} }),
    },
  ])
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  return (
    <div className="page">
      {project ? <ProjectHead project={project} members={overview?.reviewers} /> : <h1>Project</h1>}
      <Refusal inset error={error ?? noOverview} />
      {project && overview && (
        <div className={`columns ${classes.columns}`}>
          <div className="stack">
            {project.mine.is_producer && <HandoverCard projectId={projectId} />}
            <StepsCard project={project} overview={overview} />
            {(maySpeak || !isTeam) && (
              <PaceCard projectId={projectId} isProducer={project?.mine.is_producer ?? false} />
            )}
            <SpecCard project={project} />
            <PaletteCard projectId={projectId} palette={overview.palette} cues={overview.cues} />
            {isTeam && <PlaceholdersCard projectId={projectId} />}
          </div>
          <aside className="stack" aria-label="Builds, pack and what happened">
            {isTeam && <BuildsCard project={project} builds={overview.builds} />}
            {isTeam && <PackCard projectId={projectId} />}
            {!isTeam && <PlaylistsCard projectId={projectId} />}
            <CalendarCard projectId={projectId} />
            <LatelyCard projectId={projectId} happened={overview.lately} />
          </aside>
        </div>
      )}
    </div>
  )
}
