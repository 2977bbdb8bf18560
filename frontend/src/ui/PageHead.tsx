import type { ReactNode } from 'react'

import classes from './PageHead.module.css'

interface PageHeadProps {
  title: ReactNode
  /** One line below: what the page is for, or how things stand. */
  children?: ReactNode
  /** At the right end: the page's acts, the first one filled. */
  actions?: ReactNode
}

/** The head of a page: what it is, and what one can do on it. */
export function PageHead({ title, children, actions }: PageHeadProps) {
  return (
    <header className={`flex wrap gap-2-4 ${classes.head}`}>
      <div className="grow">
        <h1>{title}</h1>
        {children && <p className="mid">{children}</p>}
      </div>
      {actions && <div className="row wrap">{actions}</div>}
    </header>
  )
}
