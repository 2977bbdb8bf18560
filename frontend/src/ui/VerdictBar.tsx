import type { ReactNode } from 'react'

import classes from './VerdictBar.module.css'

interface VerdictBarProps {
  /** Who decides, and the round: "You decide. Round 1 of 2." */
  who?: ReactNode
  /** What follows from it: "A makes Alpha 4 of 10." */
  follows?: ReactNode
  /** Buttons, the first one last and filled; none where what is open above has its own. */
  children?: ReactNode
  /** What opens in place above the bar: the reasons of a change. */
  above?: ReactNode
}

/** Where a verdict is given: who decides and what it costs at the left, the actions at the right. */
export function VerdictBar({ who, follows, children, above }: VerdictBarProps) {
  return (
    <section aria-label="Verdict" className={`bg-surface ${classes.bar}`}>
      {above && <div className={`border-b narrow-p-3 ${classes.above}`}>{above}</div>}
      {children && (
        <div className={`flex wrap items-center ${classes.line}`}>
          <div className={`flex wrap items-baseline min-w-0 ${classes.says}`}>
            <p className="strong">{who}</p>
            {follows && <p className="small mid">{follows}</p>}
          </div>
          <div className={`flex wrap gap-2 end ${classes.acts}`}>{children}</div>
        </div>
      )}
    </section>
  )
}
