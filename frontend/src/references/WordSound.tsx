import { useState } from 'react'

import type { Reference } from './api'
import classes from './References.module.css'
import { ReferenceDialog } from './ReferenceDialog'
import { ReferenceTile } from './ReferenceTile'

/** The sound of a word, played at once. */
export function WordSound({ reference }: { reference: Reference }) {
  const [shown, setShown] = useState<Reference | null>(null)
  return (
    <span className={`block mt-2 ${classes.wordSound}`}>
      <ReferenceTile reference={reference} plays onShow={setShown} />
      <ReferenceDialog reference={shown} onClose={() => setShown(null)} />
    </span>
  )
}
