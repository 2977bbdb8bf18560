import { TextInput } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { useQuery } from '@tanstack/react-query'
import { type KeyboardEvent, useState } from 'react'

import { sentence } from '@/ui/sentence'
import { Button } from '@/ui/Button'

import { secondsOf } from '../pins'
import { guessQuery } from './api'
import { clock, type Mark, nameOf } from './marks'
import classes from './Spotting.module.css'

interface MarkRowProps {
  mark: Mark
  at: number
  clipName: string
  projectId: string
  isSelected: boolean
  /** What the server found wrong, by the field of the cue. */
  faults: Readonly<Record<string, string>>
  /** The id of the list of known categories. */
  categories: string
  onSelect: () => void
  onChange: (change: Partial<Mark>, field: string) => void
  onRemove: () => void
}

/** One mark as the cue that it becomes. */
export function MarkRow({
  mark,
  at,
  clipName,
  projectId,
  isSelected,
  faults,
  categories,
  onSelect,
  onChange,
  onRemove,
}: MarkRowProps) {
  const called = nameOf(mark, at, clipName)
  const [asked] = useDebouncedValue(mark.name.trim(), 300)
  const { data: guess } = useQuery({ ...guessQuery(projectId, asked), enabled: asked !== '' && mark.category === null })
  const fault = (field: string) => faults[field] && sentence(faults[field])
  const follow = (event: KeyboardEvent<HTMLInputElement>) => {
    if (event.key !== 'Enter' || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    const names = [...document.querySelectorAll<HTMLInputElement>('[data-mark-name]')]
    names[names.indexOf(event.currentTarget) + 1]?.focus()
  }
  return (
    // Its fields take the focus; the row shows which mark they are of.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <li className={`grid items-start gap-2 ${classes.row}`} data-selected={isSelected || undefined} onFocus={onSelect}>
      <span className="small dim num">{at + 1}</span>
      <TimeField
        label={`Time of ${called}`}
        valueS={mark.startS}
        onTime={(startS) => startS !== null && onChange({ startS }, 'start')}
      />
      <TimeField
        label={`Length of ${called}`}
        valueS={mark.lengthS}
        onTime={(lengthS) => onChange({ lengthS }, 'length')}
        error={fault('duration_s')}
      />
      <TextInput
        aria-label={`Name of mark ${at + 1}`}
        data-mark-name={mark.id}
        maxLength={200}
        value={mark.name}
        placeholder={called}
        error={fault('name') ?? fault('file_name')}
        onKeyDown={follow}
        onChange={({ currentTarget: { value } }) => onChange({ name: value }, 'name')}
      />
      <TextInput
        aria-label={`Category of ${called}`}
        list={categories}
        maxLength={60}
        value={mark.category ?? guess ?? ''}
        placeholder="Category"
        error={fault('category')}
        onChange={({ currentTarget: { value } }) => onChange({ category: value }, 'category')}
      />
      <Button square variant="quiet" icon="cross" aria-label={`Delete ${called}`} onClick={onRemove} />
    </li>
  )
}

interface TimeFieldProps {
  label: string
  valueS: number | null
  onTime: (s: number | null) => void
  error?: string
}

/** A time that is typed; what cannot be read stays, with what is wanted. */
function TimeField({ label, valueS, onTime, error }: TimeFieldProps) {
  const [typed, setTyped] = useState<string | null>(null)
  const isWrong = typed !== null && secondsOf(typed) === undefined
  return (
    <TextInput
      aria-label={label}
      inputMode="decimal"
      className="mono"
      value={typed ?? (valueS === null ? '' : clock(valueS))}
      placeholder="–"
      error={isWrong ? 'Seconds, as in 1.2, or 0:01.2.' : error}
      onChange={({ currentTarget: { value } }) => {
        setTyped(value)
        const seconds = secondsOf(value)
        if (seconds !== undefined) onTime(seconds)
      }}
      onBlur={() => !isWrong && setTyped(null)}
    />
  )
}
