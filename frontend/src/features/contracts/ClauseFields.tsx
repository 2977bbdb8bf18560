import { Checkbox, NumberInput, Select, Textarea, TextInput } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'

import type { Clause, Draft, LibraryClause } from './api'
import { moveButtonId, termsOf } from './clauses'
import classes from './Contracts.module.css'
import { inWords } from './words'

interface ClauseFieldsProps {
  clause: Clause
  known: LibraryClause | undefined
  terms: Draft['terms']
  currency: string
  /** Its place among the clauses, from 1, and how many there are. */
  place: number
  places: number
  onChange: (changes: Partial<Clause>) => void
  onTerm: (name: string, value: number | string) => void
  onMove: (by: -1 | 1) => void
  onRemove: () => void
}

/** One clause of a draft: whether it stands, what it leaves open, its words, and its place. */
export function ClauseFields({
  clause,
  known,
  terms,
  currency,
  place,
  places,
  onChange,
  onTerm,
  onMove,
  onRemove,
}: ClauseFieldsProps) {
  const [open, setOpen] = useState(clause.text === '')
  const used = termsOf(clause, known, terms)
  return (
    <div className="grid gap-2 border-t p-3-inset">
      <div className="flex items-start between gap-3">
        <Checkbox
          label={clause.title}
          description={known?.why}
          checked={clause.stands}
          onChange={({ currentTarget: { checked } }) => onChange({ stands: checked })}
        />
        <div className="flex wrap justify-end gap-2px">
          <Button
            variant="quiet"
            icon="pencil"
            aria-expanded={open}
            aria-label={`Edit ${clause.title}`}
            onClick={() => setOpen(!open)}
          >
            Edit
          </Button>
          {([-1, 1] as const).map((by) => (
            <Button
              key={by}
              id={moveButtonId(clause.key, by)}
              variant="quiet"
              square
              icon="chevron"
              className={by < 0 ? classes.up : undefined}
              disabled={place + by < 1 || place + by > places}
              aria-label={`Move ${clause.title} ${by < 0 ? 'up' : 'down'}`}
              onClick={() => onMove(by)}
            />
          ))}
          <Button variant="quiet" square icon="cross" aria-label={`Remove ${clause.title}`} onClick={onRemove} />
        </div>
      </div>
      {clause.stands && used.length > 0 && (
        <div className={`grid items-end gap-2-3 grid-cols-fill-180px ${classes.terms}`}>
          {used.map((name) => (
            <TermField
              key={name}
              name={name}
              known={known?.terms.find((term) => term.name === name)}
              value={terms[name] ?? ''}
              currency={currency}
              onChange={(value) => onTerm(name, value)}
            />
          ))}
        </div>
      )}
      {open && (
        <div className={classes.inner}>
          <TextInput
            label="Clause title"
            value={clause.title}
            maxLength={120}
            onChange={({ currentTarget: { value } }) => onChange({ title: value })}
          />
          <Textarea
            label="Text"
            description="Words in braces are filled in for you: {studio}, {designer}, {milestones}. **Bold**, *italic*, “- ” for a list."
            autosize
            minRows={4}
            value={clause.text}
            onChange={({ currentTarget: { value } }) => onChange({ text: value })}
          />
        </div>
      )}
    </div>
  )
}

interface TermFieldProps {
  name: string
  known: LibraryClause['terms'][number] | undefined
  value: number | string
  currency: string
  onChange: (value: number | string) => void
}

/** What a clause leaves open, in the field that fits it: a choice, a day, a text, a percentage, an amount or a number. */
export function TermField({ name, known, value, currency, onChange }: TermFieldProps) {
  const label = known?.label ?? inWords(name)
  const choices = known?.choices ?? []
  if (choices.length > 0) {
    return (
      <Select
        label={label}
        data={choices.map((choice) => ({ value: String(choice.value), label: choice.label }))}
        value={String(value)}
        allowDeselect={false}
        onChange={(taken) => onChange(choices.find((choice) => String(choice.value) === taken)?.value ?? value)}
      />
    )
  }
  if (name.endsWith('_on')) {
    return (
      <TextInput
        type="date"
        label={label}
        value={String(value)}
        onChange={({ currentTarget }) => onChange(currentTarget.value)}
      />
    )
  }
  if (typeof value === 'string') {
    return <TextInput label={label} value={value} onChange={({ currentTarget }) => onChange(currentTarget.value)} />
  }
  if (name.endsWith('_bp')) return <Percent label={label} value={value} onChange={onChange} />
  if (name.endsWith('_minor')) {
    const digits =
      new Intl.NumberFormat('en', {
        style: 'currency',
        currency: isCurrency(currency) ? currency : 'USD',
      }).resolvedOptions().maximumFractionDigits ?? 2
    const scale = 10 ** digits
    return (
      <NumberInput
        label={`${label}, ${currency}`}
        value={value / scale}
        min={0}
        decimalScale={digits}
        onChange={(given) => onChange(Math.round(Number(given) * scale))}
      />
    )
  }
  return (
    <NumberInput
      label={label}
      value={value}
      min={0}
      allowDecimal={false}
      onChange={(given) => onChange(Math.round(Number(given)))}
    />
  )
}

const isCurrency = (code: string): boolean => /^[A-Z]{3}$/.test(code)

interface PercentProps {
  label: string
  value: number
  max?: number
  onChange: (basisPoints: number) => void
}

/** Basis points as a percentage. */
export function Percent({ label, value, max, onChange }: PercentProps) {
  return (
    <NumberInput
      label={label}
      suffix=" %"
      value={value / 100}
      min={0}
      max={max === undefined ? undefined : max / 100}
      decimalScale={2}
      onChange={(given) => onChange(Math.round(Number.parseFloat(String(given) || '0') * 100))}
    />
  )
}
