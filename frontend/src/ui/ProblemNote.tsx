import type { ReactNode } from 'react'

import { Icon } from './Icon'
import classes from './ProblemNote.module.css'

interface ProblemNoteProps {
  /** What was refused or what broke, in a sentence. */
  detail: string
  /** What to do about it. */
  fix?: string
  action?: ReactNode
}

/** A refusal, said where it happened and until it is put right. */
export function ProblemNote({ detail, fix, action }: ProblemNoteProps) {
  return (
    <div role="alert" className={`${classes.note} tone-bad`}>
      <Icon name="back" />
      <p>
        <span className="toned">{detail}</span> {fix}
      </p>
      {action}
    </div>
  )
}
