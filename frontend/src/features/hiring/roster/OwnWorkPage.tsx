import { useQuery } from '@tanstack/react-query'

import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import forms from '../Hiring.module.css'
import { ownWorkQuery } from './api'
import { FiguresCard } from './FiguresCard'
import { OwnProjects } from './OwnProjects'

/** What each studio knows of the current person from work there; no other studio sees it. */
export function OwnWorkPage() {
  useTitle('Your work')
  const { data: studios, error } = useQuery(ownWorkQuery)
  return (
    <div className={`page stack ${forms.sheet}`} aria-busy={studios === undefined && error === null}>
      <PageHead title="Your work">
        Your credit, the people you work with and the playlists with your sounds, by project.
      </PageHead>
      <OwnProjects />
      <div>
        <h2>What studios see</h2>
        <p className="mid">
          What each studio sees of your work there, computed from what was decided and logged. No other studio sees it.
        </p>
      </div>
      <Refusal error={error} />
      {studios?.length === 0 && (
        <EmptyState head="No work yet">
          Once you have worked on a project, its studio’s figures are shown here.
        </EmptyState>
      )}
      {studios?.map((figures) => (
        <FiguresCard key={figures.studio_id} figures={figures} title={figures.studio_name} />
      ))}
    </div>
  )
}
