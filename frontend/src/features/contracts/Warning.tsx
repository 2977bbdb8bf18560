import type { ReactNode } from 'react'

import { Icon } from '@/ui/Icon'

import classes from './Contracts.module.css'

/** A sentence worth reading before one signs. */
export function Warning({ children, good = false }: { children: ReactNode; good?: boolean }) {
  return (
    <p className={`grid gap-2 m-0 ${classes.warning} ${good ? classes.good : ''}`}>
      <Icon name={good ? 'tick' : 'triangle'} />
      <span>{children}</span>
    </p>
  )
}
