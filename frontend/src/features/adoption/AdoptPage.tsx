import { useQuery } from '@tanstack/react-query'
import { Link, useParams, useSearch } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useMyProject } from '@/api/me'
import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'

import { adoptionsQuery, type Adoption } from './api'
import { at } from './at'
import { ChooseFolder } from './ChooseFolder'
import { AdoptionDetail } from './AdoptionDetail'

/** A folder of sounds that ship already becomes cues with approved takes. */
export function AdoptPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const { adoption } = useSearch({ from: '/shell/projects/$projectId/sound-list/adopt' })
  const project = useMyProject(projectId)
  const mayAdopt = (project?.is_producer || project?.is_approver) ?? false
  useTitle('Import existing game audio')
  const former = useQuery({ ...adoptionsQuery(projectId), enabled: project?.part === 'team' })
  return (
    <div className="page stack content-start">
      <PageHead
        title="Import existing game audio"
        actions={
          <ButtonLink component={Link} to={`/projects/${projectId}/sound-list`}>
            Back to the list
          </ButtonLink>
        }
      >
        Each sound becomes an approved take of a cue, without review, contract or money. The names stay.
      </PageHead>
      <Refusal error={former.error} />
      {project !== undefined && !mayAdopt ? (
        <EmptyState head="Only a producer or the project’s approver can adopt a folder">
          Adopting a folder approves every sound in it.
        </EmptyState>
      ) : (
        project !== undefined &&
        (adoption === undefined ? (
          <ChooseFolder key={projectId} projectId={projectId} />
        ) : (
          <AdoptionDetail key={adoption} projectId={projectId} adoptionId={adoption} />
        ))
      )}
      {mayAdopt && former.data && <Former projectId={projectId} adoptions={former.data} shown={adoption} />}
    </div>
  )
}

function Former({
  projectId,
  adoptions,
  shown,
}: {
  projectId: string
  adoptions: readonly Adoption[]
  shown: string | undefined
}) {
  const others = adoptions.filter(({ id }) => id !== shown)
  if (others.length === 0) return null
  return (
    <Card aria-labelledby="former">
      <CardHead id="former" title="Folders of this project" count={others.length} />
      <ul className="grid gap-1 wrap-anywhere p-3-inset">
        {others.map((adoption) => (
          <li key={adoption.id}>
            <Link
              className="link"
              to="/projects/$projectId/sound-list/adopt"
              params={{ projectId }}
              search={{ adoption: adoption.id }}
            >
              {adoption.folder}
            </Link>{' '}
            <span className="small dim">{stands(adoption)}</span>
          </li>
        ))}
      </ul>
    </Card>
  )
}

const stands = ({ created_at: sent, adopted_at: adopted, adopted_by: by, undone_at: undone }: Adoption): string => {
  if (undone !== null) return `undone ${at(undone)}`
  if (adopted !== null) return `adopted by ${by?.name ?? ''}, ${at(adopted)}`
  return `sent ${at(sent)}, not adopted`
}
