import { useQueryClient } from '@tanstack/react-query'
import { type KeyboardEvent, useEffect, useId, useRef, useState } from 'react'

import { useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { FieldError } from '@/ui/FieldError'
import { day } from '@/ui/format'

import { type Cue, problemIn, readAgain, useChangeCue } from '../api'
import type { OwnColumn } from './api'
import { choicesOf } from './values'
import classes from './ValueCell.module.css'

interface ValueCellProps {
  cue: Cue
  column: OwnColumn
  projectId: string
  mayEdit: boolean
}

/** The value of a cue in a column of the project's own; pressed, it becomes a field. */
export function ValueCell({ cue, column, projectId, mayEdit }: ValueCellProps) {
  const [open, setOpen] = useState(false)
  const button = useRef<HTMLButtonElement>(null)
  const value = cue.extra[column.name] ?? ''
  const shown = column.kind === 'date' && value !== '' ? day(value) : value
  if (!mayEdit || cue.state === 'cut') return <span title={shown}>{shown}</span>
  if (open) {
    return (
      <ValueField
        cue={cue}
        column={column}
        projectId={projectId}
        onClose={(refocus) => {
          setOpen(false)
          if (refocus) requestAnimationFrame(() => button.current?.focus())
        }}
      />
    )
  }
  return (
    <button
      ref={button}
      type="button"
      className={`block min-h-24px nowrap overflow-hidden w-full rounded-s bg-none text-ellipsis ${classes.value}`}
      aria-label={`${column.name} of ${cue.name}: ${shown || 'empty'}`}
      title={shown}
      onClick={(event) => {
        event.stopPropagation()
        setOpen(true)
      }}
    >
      {shown}
    </button>
  )
}

interface ValueFieldProps {
  cue: Cue
  column: OwnColumn
  projectId: string
  onClose: (refocus: boolean) => void
}

function ValueField({ cue, column, projectId, onClose }: ValueFieldProps) {
  const client = useQueryClient()
  const id = useId()
  const change = useChangeCue(projectId)
  const before = cue.extra[column.name] ?? ''
  const [text, setText, draft] = useDraft(`value:${cue.id}:${column.id}`, before)
  const [fault, setFault] = useState<string | null>(null)
  const field = useRef<HTMLInputElement & HTMLSelectElement>(null)
  useEffect(() => field.current?.focus(), [])

  const put = async (value: string, edition: number) =>
    change.mutateAsync({ cueId: cue.id, edition, facts: { extra: { ...cue.extra, [column.name]: value } } })
  const save = async (typed: string, refocus: boolean) => {
    if (change.isPending) return
    if (typed.trim() === before) {
      draft.discard()
      onClose(refocus)
      return
    }
    try {
      const saved = await put(typed, cue.edition)
      draft.discard()
      showToast(`${column.name} of ${cue.name} saved.`, async () => {
        await put(before, saved.edition)
      })
      onClose(refocus)
    } catch (error) {
      const problem = problemIn(error)
      if (problem === null) throw error
      setFault(problem.errors[0]?.message ?? problem.detail)
      if (problem.code === 'cue-changed') void readAgain(client, projectId, cue.id)
    }
  }
  const keys = (event: KeyboardEvent) => {
    if (event.key === 'Enter') {
      event.preventDefault()
      void save(text, true)
    } else if (event.key === 'Escape') {
      event.stopPropagation()
      draft.discard()
      onClose(true)
    }
  }
  const shared = {
    ref: field,
    className: classes.field,
    'aria-label': `${column.name} of ${cue.name}`,
    'aria-invalid': fault !== null || undefined,
    'aria-describedby': fault === null ? undefined : id,
    onKeyDown: keys,
    onClick: (event: { stopPropagation: () => void }) => event.stopPropagation(),
    onBlur: () => void save(text, false),
  }
  const choices = choicesOf(column)
  return (
    <span className={`block ${classes.open}`}>
      {choices ? (
        <select {...shared} value={text} onChange={(event) => setText(event.currentTarget.value)}>
          <option value="">–</option>
          {choices.map((choice) => (
            <option key={choice} value={choice}>
              {choice}
            </option>
          ))}
        </select>
      ) : (
        <input
          {...shared}
          type={column.kind === 'date' ? 'date' : 'text'}
          inputMode={column.kind === 'number' ? 'decimal' : undefined}
          value={text}
          onChange={(event) => setText(event.currentTarget.value)}
        />
      )}
      {fault && <FieldError id={id}>{fault}</FieldError>}
    </span>
  )
}
