import type { ReactNode } from 'react'

import { Button } from '@/ui/Button'
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
          </>
        )
      }
    >
      {mayEdit
        ? 'Type the first cues (only a name is required), paste rows from a spreadsheet with Ctrl V, or import a CSV or XLSX file.'
        : 'The team has not added any cues yet.'}
    </EmptyState>
  )
}
