import type { ReactNode } from 'react'

import classes from './Finding.module.css'
import { Icon } from './Icon'
import { SEVERITY_LOOK, type Severity } from './severity'

interface FindingProps {
  severity: Severity
  /** The measured figure: "Sample peak 0.0 dBFS"; for a judgement the question it asks. */
  head: string
  /** Where in the sound, or how much: "0.418 s". */
  where?: string
  /** The limit and what follows from it, then what to do. */
  children: ReactNode
  /** The spot, Fix, the check's page. */
  actions?: ReactNode
}

/** One finding: what, the limit, where, and what to do next. */
export function Finding({ severity, head, where, children, actions }: FindingProps) {
  const { tone, icon, label } = SEVERITY_LOOK[severity]
  return (
    <article className={`${classes.finding} tone-${tone}`} aria-label={head}>
      <header className="flex items-baseline gap-6px">
        <span className={`flex ${classes.icon}`}>
          <Icon name={icon} />
        </span>
        <span className="strong toned">
          <span className="visually-hidden">{label}</span>
          {head}
        </span>
        {where && <span className="mono small dim end nowrap">{where}</span>}
      </header>
      <p className="wrap-anywhere">{children}</p>
      {actions && <div className="row wrap mt-6px">{actions}</div>}
    </article>
  )
}
