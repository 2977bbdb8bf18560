import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { useState } from 'react'

import { Count } from '@/ui/Count'

import { cueReferencesQuery, type Reference } from './api'
import classes from './References.module.css'
import { ReferenceDialog } from './ReferenceDialog'
import { ReferenceTile } from './ReferenceTile'

interface ReferenceStripProps {
  projectId: string
  cueId: string
  /** Whether the person may add references. */
  mayAdd?: boolean
}

/** What shows how a cue is meant, beside the cue; nothing where there is none and none can be added. */
export function ReferenceStrip({ projectId, cueId, mayAdd = false }: ReferenceStripProps) {
  const { data: references } = useQuery(cueReferencesQuery(projectId, cueId))
  const [shown, setShown] = useState<Reference | null>(null)
  if (references === undefined || (references.length === 0 && !mayAdd)) return null
  return (
    <section className="grid grid-cols-1 gap-2 min-w-0" aria-label="References">
      <header className="row wrap">
        <h2>References</h2>
        {references.length > 0 && <Count of={references.length} />}
        <Link
          className="link small end"
          to="/projects/$projectId/references"
          params={{ projectId }}
          search={{ cue: cueId }}
        >
          {mayAdd ? 'Add on the board' : 'All references'}
        </Link>
      </header>
      {references.length === 0 ? (
        <p className="small dim">None yet. A picture, a clip or a similar sound says more than a description.</p>
      ) : (
        <div className={`grid gap-3 ${classes.row}`}>
          {references.map((reference) => (
            <ReferenceTile key={reference.id} reference={reference} onShow={setShown}>
              {reference.category !== null && <p className="small dim">for all of {reference.category}</p>}
            </ReferenceTile>
          ))}
        </div>
      )}
      <ReferenceDialog reference={shown} onClose={() => setShown(null)} />
    </section>
  )
}
