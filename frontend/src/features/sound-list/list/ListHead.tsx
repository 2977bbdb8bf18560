import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { RefusedNamesNote } from '@/app/RefusedNames'
import { plural } from '@/ui/format'
import { type NeedSum, NeedSums } from '@/ui/NeedSums'

import { compareQuery, type Cue } from '../api'
import { CoverageNote } from './CoverageNote'
import classes from './SoundList.module.css'

interface ListHeadProps {
  projectId: string
  list: { revision: number; cues: Cue[] } | undefined
  mayEdit: boolean
  needs: readonly NeedSum[]
}

/** The size of the list, its last change, and what all of it amounts to. */
export function ListHead({ projectId, list, mayEdit, needs }: ListHeadProps): ReactNode {
  const revision = list?.revision ?? 0
  return (
    <header className="row wrap between">
      <div className="flex wrap items-baseline gap-0-3">
        <h1>Sound list</h1>
        {list && (
          <span className="mid">
            {plural(list.cues.length, 'cue')}, revision {revision}
          </span>
        )}
        {revision > 1 && <LastChange projectId={projectId} revision={revision} />}
      </div>
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
