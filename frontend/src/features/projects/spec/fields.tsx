import { Select, TextInput } from '@mantine/core'
import { createContext, useContext, useId, useState } from 'react'

import { FieldError } from '@/ui/FieldError'
import { Segmented } from '@/ui/Segmented'
import { sentence } from '@/ui/sentence'

import { type Severity, severityOf } from './checks'
import classes from './SpecForm.module.css'
import { at, type Tables, tableIn, typedNumber } from './tables'
import { isAt, type Trouble } from './trouble'

export interface SpecWriting {
  tables: Tables
  set: (place: readonly string[], value: unknown) => void
  /** Change the tables as a whole, as when a target gets another name. */
  change: (change: (tables: Tables) => Tables) => void
  trouble: Trouble | null
}

export const Writing = createContext<SpecWriting | null>(null)

export function useWriting(): SpecWriting {
  const writing = useContext(Writing)
  if (writing === null) throw new Error('a field of the spec stands outside its form')
  return writing
}

const fieldId = (place: readonly string[]) => `spec-${place.join('.')}`

/** The sentence that stands against a field, if any does. */
function useTrouble(place: readonly string[]): string | undefined {
  const { trouble } = useWriting()
  return trouble && isAt(trouble, place) ? sentence(trouble.message) : undefined
}

export function Against({ place }: { place: readonly string[] }) {
  const message = useTrouble(place)
  return message === undefined ? null : <FieldError>{message}</FieldError>
}

/** What holds at a place when a category says nothing of it. */
function useAbove(place: readonly string[]): unknown {
  const { tables } = useWriting()
  return place[0] === 'categories' ? at(tables, place.slice(2)) : undefined
}

interface NumberFieldProps {
  place: readonly string[]
  label: string
  unit: string
  /** Already shown next to it. */
  hideLabel?: boolean
  usual?: number
}

const shown = (value: unknown): string =>
  typeof value === 'number' || typeof value === 'string' ? String(value).replace('-', '−') : ''

/** A figure with its unit; empty means no limit. Text that is not a number stays as typed and is reported. */
export function NumberField({ place, label, unit, hideLabel = false, usual }: NumberFieldProps) {
  const { tables, set } = useWriting()
  const value = at(tables, place)
  const above = useAbove(place)
  const [typed, setTyped] = useState('')
  const text = typedNumber(typed) === value ? typed : shown(value)
  const inherited =
    above === undefined ? (usual === undefined ? 'no limit' : shown(usual)) : `general rule: ${shown(above)}`
  return (
    <TextInput
      id={fieldId(place)}
      label={hideLabel ? undefined : label}
      aria-label={hideLabel ? `${label}, ${unit}` : undefined}
      inputMode="text"
      autoComplete="off"
      className={classes.number}
      value={text}
      placeholder={inherited}
      rightSection={<span className="small dim">{unit}</span>}
      rightSectionWidth={44}
      error={useTrouble(place)}
      onChange={({ currentTarget }) => {
        setTyped(currentTarget.value)
        set(place, typedNumber(currentTarget.value))
      }}
    />
  )
}

interface ChoicesProps {
  place: readonly string[]
  label: string
  options: readonly { value: string | number; label: string }[]
  /** What the list means when it does not limit: "any". */
  mayBeAny?: boolean
}

/** Several of a few; what the text says beyond them stands among them. */
export function Choices({ place, label, options, mayBeAny = true }: ChoicesProps) {
  const { tables, set } = useWriting()
  const id = useId()
  const stored = at(tables, place)
  const above = useAbove(place)
  const isCategory = place[0] === 'categories'
  const held = stored ?? (isCategory ? above : undefined)
  const chosen: (string | number)[] = Array.isArray(held) ? (held as (string | number)[]) : []
  const own = chosen.filter((value) => options.every((option) => option.value !== value))
  const all = [...options, ...own.map((value) => ({ value, label: String(value) }))]
  const any = mayBeAny && !Array.isArray(held)
  const toggle = (value: string | number) => {
    const next = chosen.includes(value) ? chosen.filter((other) => other !== value) : [...chosen, value]
    const order = all.map((option) => option.value)
    set(
      place,
      next.toSorted((a, b) => order.indexOf(a) - order.indexOf(b)),
    )
  }
  return (
    <div className={`min-w-0 ${classes.field}`} data-quiet={(isCategory && stored === undefined) || undefined}>
      <span id={id} className={`block mid text-small leading-small ${classes.label}`}>
        {label}
      </span>
      <div role="group" aria-labelledby={id} className="flex wrap items-center gap-1" id={fieldId(place)}>
        {all.map((option) => (
          <button
            type="button"
            key={option.value}
            className={`hover mid pointer min-h-28px border-edge rounded narrow-min-h-44px ${classes.choice}`}
            aria-pressed={chosen.includes(option.value)}
            onClick={() => toggle(option.value)}
          >
            {option.label}
          </button>
        ))}
        {mayBeAny && (
          <button
            type="button"
            className={`hover mid pointer min-h-28px border-edge rounded narrow-min-h-44px ${classes.choice}`}
            aria-pressed={any}
            onClick={() => set(place, 'any')}
          >
            any
          </button>
        )}
        {isCategory && stored !== undefined && (
          <button type="button" className="link small" onClick={() => set(place, undefined)}>
            general rule
          </button>
        )}
        {isCategory && stored === undefined && <span className="small dim">general rule</span>}
      </div>
      <Against place={place} />
    </div>
  )
}

const SEVERITIES = [
  { value: 'error', label: 'returns' },
  { value: 'warning', label: 'warns' },
  { value: 'off', label: 'off' },
] as const

interface SeverityFieldProps {
  /** Where the checks stand: ["checks"], or those of a category. */
  base: readonly string[]
  check: string
  label: string
  usual?: Severity
  /** Whether a take can come back for it. */
  returns?: boolean
}

/** What follows when a rule is broken. */
export function SeverityField({ base, check, label, usual = 'error', returns = true }: SeverityFieldProps) {
  const { tables, set } = useWriting()
  const place = [...base, check]
  const checks = tableIn(at(tables, base))
  const name = `${label}: result`
  if (base[0] !== 'categories') {
    return (
      <Segmented
        label={name}
        options={returns ? SEVERITIES : SEVERITIES.filter(({ value }) => value !== 'error')}
        value={severityOf(checks, check, usual)}
        onChange={(value) => set(place, value)}
      />
    )
  }
  const above = severityOf(tableIn(tables.checks), check, usual)
  const word = SEVERITIES.find(({ value }) => value === above)?.label ?? above
  return (
    <Choice
      label={name}
      hideLabel
      value={typeof checks[check] === 'string' ? checks[check] : ''}
      options={[{ value: '', label: `general rule: ${word}` }, ...SEVERITIES]}
      onChange={(value) => set(place, value === '' ? undefined : value)}
    />
  )
}

interface ChoiceProps {
  label: string
  hideLabel?: boolean
  value: string
  options: readonly { value: string; label: string }[]
  onChange: (value: string) => void
  error?: string
}

/** One of a few. */
export function Choice({ label, hideLabel = false, value, options, onChange, error }: ChoiceProps) {
  return (
    <Select
      label={hideLabel ? undefined : label}
      aria-label={hideLabel ? label : undefined}
      data={options.map((option) => ({ ...option }))}
      value={value}
      allowDeselect={false}
      error={error}
      onChange={(next) => onChange(next ?? value)}
    />
  )
}
