import type { ReactNode } from 'react'

import { KeysLine } from '@/ui/KeysLine'

import classes from './SoundList.module.css'

/** The keys of the list, why a sound does not play, and what the shown cues add up to. */
export function ListFoot({
  mayEdit,
  error,
  sums,
}: {
  mayEdit: boolean
  error: string | null
  sums: string
}): ReactNode {
  return (
    <footer className={`flex wrap items-center between gap-1-4 ${classes.foot}`}>
      <KeysLine
        keys={[
          { keys: ['j', 'k'], label: 'move' },
          { keys: ['Space'], label: 'play' },
          { keys: ['Enter'], label: 'open' },
          ...(mayEdit
            ? [
                { keys: ['e'], label: 'edit' },
                { keys: ['m'], label: 'need' },
                { keys: ['x'], label: 'select' },
              ]
            : []),
          { keys: ['q'], label: 'ask a question' },
          { keys: ['f'], label: 'filter by state' },
        ]}
      />
      {error && (
        <p role="alert" className="small tone-bad toned">
          {error}
        </p>
      )}
      <p className="small dim">{sums}</p>
    </footer>
  )
}
