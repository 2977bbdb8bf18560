import { Link, useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { Button, ButtonLink } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'

/** What to do with a sound list that has no cue yet. */
export function EmptyList({
  mayEdit,
  onAdd,
  onImport,
}: {
  mayEdit: boolean
  onAdd: () => void
  onImport: () => void
}): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  return (
    <EmptyState
      head="The sound list is empty"
      action={
        mayEdit && (
          <>
            <Button variant="primary" icon="plus" keys="n" onClick={onAdd}>
              Add a cue
            </Button>
            <Button keys="i" onClick={onImport}>
              Paste or import
            </Button>
            <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/kits`}>
              Start from a kit
            </ButtonLink>
            <ButtonLink component={Link} to={`/projects/${projectId}/sound-list/adopt`}>
              Import existing game audio
            </ButtonLink>
          </>
        )
      }
    >
      {mayEdit
        ? 'Type the first cues (only a name is required), paste rows from a spreadsheet with Ctrl V, import a CSV or XLSX file, or start from the cues of a kind of game.'
        : 'The team has not added any cues yet.'}
    </EmptyState>
  )
}
