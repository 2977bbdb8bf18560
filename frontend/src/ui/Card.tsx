import type { ComponentPropsWithRef, ReactNode } from 'react'

import classes from './Card.module.css'
import { Count } from './Count'

/** A flat panel with a hairline. Cards never stand in cards. */
export function Card({ className, ...rest }: ComponentPropsWithRef<'section'>) {
  return <section {...rest} className={[classes.card, className].filter(Boolean).join(' ')} />
}

interface CardHeadProps {
  title: string
  id?: string
  count?: number | string
  /** After the title, quietly. */
  note?: ReactNode
  /** At the right: a note, or actions. */
  end?: ReactNode
}

export function CardHead({ title, id, count, note, end }: CardHeadProps) {
  return (
    <header className={`flex wrap items-center gap-0-2 border-b ${classes.head}`}>
      <h2 id={id}>{title}</h2>
      {count !== undefined && <Count of={count} />}
      {note && <span className={`min-w-0 nowrap overflow-hidden text-ellipsis ${classes.note}`}>{note}</span>}
      {end && <span className={`row end nowrap ${classes.end}`}>{end}</span>}
    </header>
  )
}
