import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { RefusedNamesNote } from '@/app/RefusedNames'
import { Button, ButtonLink } from '@/ui/Button'
import { plural } from '@/ui/format'
import { type NeedSum, NeedSums } from '@/ui/NeedSums'

import { compareQuery, type Cue } from '../api'
import { CoverageNote } from './CoverageNote'
import classes from './SoundList.module.css'

interface Acts {
  projectId: string
  mayEdit: boolean
  onAdd: () => void
  onImport: () => void
}

/** What list this is, and what can be done to all of it. */
export function ListHead({
  projectId,
  list,
  mayEdit,
  isEmpty,
  onAdd,
  onImport,
  needs,
}: Acts & {
  list: { revision: number; cues: Cue[] } | undefined
  isEmpty: boolean
  needs: readonly NeedSum[]
}): ReactNode {
  const revision = list?.revision ?? 0
  return (
    <header className={classes.top}>
      <div className={classes.title}>
        <h1>Sound list</h1>
        {list && (
          <span className="mid">
            {plural(list.cues.length, 'cue')}, revision {revision}
          </span>
        )}
        {revision > 1 && <LastChange projectId={projectId} revision={revision} />}
      </div>
      {!isEmpty && (
        <div className={`${classes.acts} wide-only`}>
          <ButtonLink variant="quiet" icon="download" href={csvOf(projectId)}>
            CSV
          </ButtonLink>
          <ButtonLink variant="quiet" icon="download" href={workbookOf(projectId)}>
            XLSX
          </ButtonLink>
          {mayEdit && (
            <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/columns`}>
              Columns
            </ButtonLink>
          )}
          {mayEdit && (
            <Button keys="i" onClick={onImport}>
              Paste or import
            </Button>
          )}
          {mayEdit && <AdoptLink projectId={projectId} />}
          <CompareLink projectId={projectId} />
          {mayEdit && (
            <Button variant="primary" icon="plus" keys="n" onClick={onAdd}>
              Add a cue
            </Button>
          )}
        </div>
      )}
      <div className={classes.needs}>
        <NeedSums sums={needs} />
      </div>
      <CoverageNote projectId={projectId} />
      {list?.cues.some(({ refused_name }) => refused_name) && (
        <RefusedNamesNote projectId={projectId} edits={mayEdit} />
      )}
    </header>
  )
}

/** The same acts at the end of the page, where it is too narrow for them beside its title. */
export function ListActsBelow({ projectId, mayEdit, onAdd, onImport }: Acts): ReactNode {
  return (
    <div className="narrow-only">
      <div className={classes.narrowActs}>
        {mayEdit && (
          <>
            <Button variant="primary" icon="plus" onClick={onAdd}>
              Add a cue
            </Button>
            <Button onClick={onImport}>Paste or import</Button>
            <AdoptLink projectId={projectId} />
          </>
        )}
        <CompareLink projectId={projectId} />
        <ButtonLink icon="download" href={csvOf(projectId)}>
          CSV
        </ButtonLink>
        <ButtonLink icon="download" href={workbookOf(projectId)}>
          XLSX
        </ButtonLink>
        {mayEdit && (
          <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/columns`}>
            Columns
          </ButtonLink>
        )}
      </div>
    </div>
  )
}

const workbookOf = (projectId: string) => `/v1/projects/${projectId}/sound-list.xlsx`
const csvOf = (projectId: string) => `/v1/projects/${projectId}/sound-list.csv`

function AdoptLink({ projectId }: { projectId: string }) {
  return (
    <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/adopt`}>
      Adopt a folder
    </ButtonLink>
  )
}

function CompareLink({ projectId }: { projectId: string }) {
  return (
    <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/compare`}>
      Compare revisions
    </ButtonLink>
  )
}

function LastChange({ projectId, revision }: { projectId: string; revision: number }) {
  const { data } = useQuery(compareQuery(projectId, revision - 1, revision))
  if (data === undefined) return null
  const lines = data.added.length + data.changed.length + data.cut.length
  return (
    <Link
      className="link mid wide-only"
      to="/projects/$projectId/sound-list/compare"
      params={{ projectId }}
      search={{ from: revision - 1, to: revision }}
    >
      {plural(lines, 'line')} changed since revision {revision - 1}
    </Link>
  )
}
