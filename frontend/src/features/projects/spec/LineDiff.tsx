import { useMemo } from 'react'

import { plural } from '@/ui/format'

import { diffLines, folded } from './diff'
import classes from './LineDiff.module.css'

interface LineDiffProps {
  before: string
  after: string
  /** What is compared, for those who listen. */
  label: string
  /** Where there is no difference. */
  same?: string
}

const SIGNS = { same: ' ', gone: '−', new: '+' }
const WORDS = { same: '', gone: 'removed: ', new: 'added: ' }

/** Two texts line by line: what went is quiet, what came is marked. */
export function LineDiff({ before, after, label, same = 'The two are identical.' }: LineDiffProps) {
  const parts = useMemo(() => folded(diffLines(before, after)), [before, after])
  if (before === after) return <p className="mid p-3-inset">{same}</p>
  return (
    // A long line scrolls, so the keyboard must reach it.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
    <div className={`bg-well overflow-x-auto ${classes.diff}`} role="region" aria-label={label} tabIndex={0}>
      {parts.map((part, index) =>
        part.kind === 'skipped' ? (
          <p key={index} className={`dim ${classes.skipped}`}>
            {`${plural(part.count, 'line')} unchanged`}
          </p>
        ) : (
          <div key={index} className={`grid gap-1 ${classes.line}`} data-kind={part.kind}>
            <span className="dim num" aria-hidden="true">
              {part.before ?? ''}
            </span>
            <span className="dim num" aria-hidden="true">
              {part.after ?? ''}
            </span>
            <span aria-hidden="true">{SIGNS[part.kind]}</span>
            <span className={classes.text}>
              {WORDS[part.kind] && <span className="visually-hidden">{WORDS[part.kind]}</span>}
              {part.text}
            </span>
          </div>
        ),
      )}
    </div>
  )
}
