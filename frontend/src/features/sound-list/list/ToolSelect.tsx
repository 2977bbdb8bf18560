import type { ReactNode } from 'react'

import { Icon } from '@/ui/Icon'

import classes from './SoundList.module.css'

interface ToolSelectProps {
  label: string
  value: string
  /** The first option, of no value: "Any need". */
  blank?: string
  /** The blank one is shown and cannot be chosen. */
  isBlankDisabled?: boolean
  options?: readonly { value: string; label: string }[]
  /** Further options. */
  children?: ReactNode
  onChoose: (value: string) => void
}

/** A choice in the bar above the list. */
export function ToolSelect({
  label,
  value,
  blank,
  isBlankDisabled = false,
  options = [],
  children,
  onChoose,
}: ToolSelectProps) {
  return (
    <span className={`inline-flex items-center relative ${classes.select}`}>
      <select aria-label={label} value={value} onChange={(event) => onChoose(event.currentTarget.value)}>
        {blank !== undefined && (
          <option value="" disabled={isBlankDisabled}>
            {blank}
          </option>
        )}
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {option.label}
          </option>
        ))}
        {children}
      </select>
      <Icon name="chevron" />
    </span>
  )
}
