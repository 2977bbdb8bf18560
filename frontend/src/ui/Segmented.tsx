import type { ReactNode } from 'react'

import classes from './Segmented.module.css'

interface SegmentedProps<T extends string> {
  label: string
  options: readonly { value: T; label: ReactNode }[]
  value: T
  onChange: (value: T) => void
}

/** A few things of which one is on: Master, Game, Handheld. */
export function Segmented<T extends string>({ label, options, value, onChange }: SegmentedProps<T>) {
  return (
    <span role="group" aria-label={label} className={`inline-flex bg-raised flex-none ${classes.segmented}`}>
      {options.map((option) => (
        <button
          type="button"
          key={option.value}
          aria-pressed={option.value === value}
          onClick={() => onChange(option.value)}
        >
          {option.label}
        </button>
      ))}
    </span>
  )
}
