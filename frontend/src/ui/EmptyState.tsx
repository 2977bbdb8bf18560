import type { ReactNode } from 'react'

import classes from './EmptyState.module.css'

interface EmptyStateProps {
  /** What is so: "Nothing waits for you." */
  head: string
  /** 1 where it is the whole page. */
  level?: 1 | 2 | 3
  /** What comes next, and when. */
  children?: ReactNode
  action?: ReactNode
}

/** An empty place that says why it is empty and what to do. */
export function EmptyState({ head, level = 2, children, action }: EmptyStateProps) {
  const Head = `h${level}` as const
  return (
    <div className={`rounded ${classes.empty}`}>
      <Head className={level === 1 ? 'title' : undefined}>{head}</Head>
      {children && <p className="mid">{children}</p>}
      {action && <div className={`flex wrap items-center gap-2-4 ${classes.action}`}>{action}</div>}
    </div>
  )
}
