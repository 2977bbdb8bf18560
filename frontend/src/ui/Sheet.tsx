import type { ReactNode } from 'react'

import { Card } from './Card'
import classes from './Form.module.css'

/** The one card of a page before an account. */
export function Sheet({ children, wide = false }: { children: ReactNode; wide?: boolean }) {
  return (
    <div className="page">
      <Card className={wide ? `${classes.sheet} ${classes.wide}` : classes.sheet}>{children}</Card>
    </div>
  )
}
