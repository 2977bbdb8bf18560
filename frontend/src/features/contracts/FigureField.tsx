import { useState } from 'react'

import { minorOf } from '@/money/words'

import type { Draft, LibraryClause } from './api'
import classes from './Draft.module.css'
import { inWords } from './words'

interface FigureFieldProps {
  name: string
  /** The figure as the text says it. */
  text: string
  value: number | string
  known: LibraryClause['terms'][number] | undefined
  currency: string
  onChange: (value: number | string) => void
}

/** A figure of the text, which is its field: what is typed here is what text, plan, invoice and review read. */
export function FigureField({ name, text, value, known, currency, onChange }: FigureFieldProps) {
  const [typed, setTyped] = useState<string | null>(null)
  const label = known?.label ?? inWords(name)
  if (known && known.choices.length > 0) {
    return (
      <select
        className={classes.figure}
        aria-label={label}
        value={String(value)}
        onChange={({ currentTarget }) => {
          const choice = known.choices.find((each) => String(each.value) === currentTarget.value)
          if (choice) onChange(choice.value)
        }}
      >
        {known.choices.map((choice) => (
          <option key={choice.value} value={String(choice.value)}>
            {choice.label}
          </option>
        ))}
      </select>
    )
  }
  const shown = typed ?? (text || String(value))
  const isWrong = typed !== null && valueOf(name, typed, value, currency) === null
  return (
    <>
      <input
        className={classes.figure}
        aria-label={label}
        aria-invalid={isWrong}
        value={shown}
        size={Math.max(shown.length, 2)}
        placeholder="empty"
        onFocus={({ currentTarget }) => currentTarget.select()}
        onBlur={() => !isWrong && setTyped(null)}
        onChange={({ currentTarget }) => {
          setTyped(currentTarget.value)
          const next = valueOf(name, currentTarget.value, value, currency)
          if (next !== null) onChange(next)
        }}
      />
      {isWrong && <span className="small tone-bad" role="alert">{` ${WANTED(name, currency)} `}</span>}
    </>
  )
}

const WANTED = (name: string, currency: string) =>
  name.endsWith('_bp')
    ? 'Write it like 25 %.'
    : name.endsWith('_minor')
      ? `Write an amount in ${currency}, like 80.00.`
      : 'Write a whole number.'

/** The value that is typed; null where it is none. */
export function valueOf(name: string, typed: string, before: Draft['terms'][string], currency: string) {
  if (typeof before === 'string') return typed
  const bare = typed.replace(/%|\b[A-Z]{3}\b/g, '').trim()
  if (name.endsWith('_minor')) return minorOf(bare, currency)
  const number = Number(bare.replaceAll(/[\s,](?=\d{3}\b)/g, '').replace(',', '.'))
  if (bare === '' || !Number.isFinite(number) || number < 0) return null
  if (name.endsWith('_bp')) return Math.round(number * 100)
  return Number.isInteger(number) ? number : null
}
