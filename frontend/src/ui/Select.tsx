import type { ComponentProps } from 'react'
import classes from './Select.module.css'

interface SelectProps extends ComponentProps<'select'> {
  /** Stands above it; without one it is named by `aria-label` or by a label that stands elsewhere. */
  label?: string
}

/** A choice among few, as the browser opens it. */
export function Select({ label, ...rest }: SelectProps) {
  const choice = (
    <select {...rest} className={`min-h-28px border-edge rounded bg-raised ink font-inherit ${classes.select}`} />
  )
  if (label === undefined) return choice
  return (
    <label className={`grid gap-1 ${classes.labelled}`}>
      <span className="small mid">{label}</span>
      {choice}
    </label>
  )
}
