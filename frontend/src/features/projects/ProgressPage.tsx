import { useQuery } from '@tanstack/react-query'
import { useNavigate, useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { overviewQuery, projectQuery } from '@/api/project'
import { useHotkeys } from '@/app/keys'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { Refusal } from '@/ui/Refusal'

import { BuildsCard } from './BuildsCard'
import { CalendarCard } from './CalendarCard'
import { HandoverCard } from './HandoverCard'
import { PaceCard } from './PaceCard'
import { PackCard } from './PackCard'
import { PaletteCard } from './PaletteCard'
import classes from './Project.module.css'
import { PlaceholdersCard } from './PlaceholdersCard'
import { SpecCard } from './spec/SpecCard'
import { StepsCard } from './StepsCard'
import { canActForStudio } from './words'

/** The figures of a project in full: every cue, the pace, the spec, the palette, the last builds and the pack. */
export function ProgressPage() {
  useTitle('Progress')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/progress' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const { data: overview, error: noOverview } = useQuery(overviewQuery(projectId))
  const navigate = useNavigate()
  const maySpeak = project !== undefined && canActForStudio(project)
  const isTeam = project?.mine.is_team ?? false
  const openSpec = () => void navigate({ to: '/projects/$projectId/spec', params: { projectId } })
  useHotkeys(maySpeak ? [{ keys: 'e', label: 'Edit delivery spec', group: 'Project', run: openSpec }] : [])
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  return (
    <div className="page">
      <h1>Progress</h1>
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
          <aside className="stack" aria-label="Builds and pack">
            {isTeam && <BuildsCard project={project} builds={overview.builds} />}
            {isTeam && <PackCard projectId={projectId} />}
            <CalendarCard projectId={projectId} />
          </aside>
        </div>
      )}
    </div>
  )
}
