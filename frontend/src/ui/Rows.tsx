import type { ComponentPropsWithRef } from 'react'

import classes from './Rows.module.css'

interface RowProps extends ComponentPropsWithRef<'li'> {
  /** Selected: tinted, with the edge of now. */
  selected?: boolean
  dense?: boolean
}

/** A list of lines with hairlines between them. */
export function Rows(props: ComponentPropsWithRef<'ul'>) {
  return <ul {...props} />
}

export function Row({ selected = false, dense = false, className, ...rest }: RowProps) {
  return (
    <li
      {...rest}
      className={[classes.line, dense ? classes.dense : '', className].filter(Boolean).join(' ')}
      data-selected={selected || undefined}
      aria-current={selected || undefined}
    />
  )
}
