import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { projectQuery, studioPeopleQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import type { Project } from './api'
import { ApprovalCard } from './people/ApprovalCard'
import { ApproverCard } from './people/ApproverCard'
import { CategoriesCard } from './people/CategoriesCard'
import { DeputiesCard } from './people/DeputiesCard'
import { HearingCard } from './people/HearingCard'
import { ReasonsCard } from './people/ReasonsCard'

interface FrameProps {
  title: string
  note: string
  children: (project: Project) => ReactNode
}

function Frame({ title, note, children }: FrameProps) {
  useTitle(title)
  const { projectId = '' } = useParams({ strict: false })
  const { data: project, error } = useQuery(projectQuery(projectId))
  return (
    <div className="page page-narrow stack">
      <PageHead title={title}>{note}</PageHead>
      <Refusal inset error={error} />
      {project?.mine.is_team === false && <p>Only the game team sees this page.</p>}
      {project?.mine.is_team && children(project)}
    </div>
  )
}

/** Who decides on the sounds of a project: its approver, those of categories, and deputies. */
export function ApproversPage() {
  return (
    <Frame title="Approvers" note="Who approves or returns every sound.">
      {(project) => <Approvers project={project} />}
    </Frame>
  )
}

function Approvers({ project }: { project: Project }) {
  const { data: members, error } = useQuery(studioPeopleQuery(project.studio.id))
  return (
    <>
      <Refusal inset error={error} />
      <ApproverCard project={project} members={members} />
      <CategoriesCard project={project} members={members} />
      <DeputiesCard project={project} members={members} />
    </>
  )
}

/** What an approval needs: checklists, reasons, and a listen. */
export function ApprovalPage() {
  return (
    <Frame title="Approval rules" note="What an approval needs before it counts.">
      {(project) => (
        <>
          <ApprovalCard project={project} />
          <ReasonsCard project={project} />
          <HearingCard project={project} />
        </>
      )}
    </Frame>
  )
}
