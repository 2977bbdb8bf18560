import type { ReactNode } from 'react'

import classes from './NeedMark.module.css'

export type Need = 'must' | 'should' | 'wish'

/** How much the game needs a cue: a full, a half or an empty square, and the word beside it. */
export function NeedMark({ need, children = need }: { need: Need; children?: ReactNode }) {
  return (
    <span className="inline-flex items-center gap-6px">
      <i className={`flex-none rounded-2px ${classes.mark}`} data-need={need} aria-hidden="true" />
      {children}
    </span>
  )
}
