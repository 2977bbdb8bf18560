import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { type ReactNode, useRef, useState } from 'react'

import type { ApiProblem } from '@/api'
import { listQuery } from '@/api/soundList'
import { DraftNote, useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Select } from '@/ui/Select'

import { type Cue, problemIn, useRights } from '../api'
import { type ColumnKind, columnsQuery, type OwnColumn, useSetColumns } from './api'
import classes from './Columns.module.css'
import { KINDS } from './values'

/** A column as it is typed: choices one a line. */
interface Typed {
  id: string | null
  name: string
  kind: ColumnKind
  choices: string
}

const NEW: Typed = { id: null, name: '', kind: 'text', choices: '' }

const typedOf = ({ id, name, kind, choices }: OwnColumn): Typed => ({ id, name, kind, choices: choices.join('\n') })

const wantedOf = ({ choices, ...column }: Typed) => ({
  ...column,
  choices: choices
    .split('\n')
    .map((choice) => choice.trim())
    .filter(Boolean),
})

/** Names that cues keep values under and that are not columns: an import brought them, or the column was removed. */
function keptNames(cues: readonly Cue[], columns: readonly Typed[]): [name: string, cues: number][] {
  const known = new Set(columns.map(({ name }) => name.trim().toLowerCase()))
  const counts = new Map<string, number>()
  for (const name of cues.flatMap(({ extra }) => Object.keys(extra))) {
    if (!known.has(name.toLowerCase())) counts.set(name, (counts.get(name) ?? 0) + 1)
  }
  return [...counts]
}

/** The columns of the project's own: their names, types and order. */
export function ColumnsPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  useTitle('Columns')
  const rights = useRights(projectId)
  const { data, error } = useQuery(columnsQuery(projectId))
  return (
    <div className={`page ${classes.page}`}>
      <PageHead
        title="Columns"
        actions={
          <ButtonLink component={Link} to={`/projects/${projectId}/sound-list`}>
            Back to the list
          </ButtonLink>
        }
      >
        Facts of your own for every cue: a bank, a mood, a scene. They are shown in the list under Content, and go out
        and in with its spreadsheet.
      </PageHead>
      <Refusal error={error} />
      {rights.known && !rights.edits && (
        <EmptyState head="Only producers and audio leads can change columns">You can read them in the list.</EmptyState>
      )}
      {rights.edits && data && <ColumnsForm projectId={projectId} columns={data.columns} edition={data.edition} />}
    </div>
  )
}

interface ColumnsFormProps {
  projectId: string
  columns: readonly OwnColumn[]
  edition: string
}

function ColumnsForm({ projectId, columns, edition }: ColumnsFormProps) {
  const [typed, setTyped, draft] = useDraft<Typed[]>(`columns:${projectId}:${edition}`, () => columns.map(typedOf))
  const [problem, setProblem] = useState<ApiProblem | null>(null)
  const { data: list } = useQuery(listQuery(projectId))
  const set = useSetColumns(projectId)
  const form = useRef<HTMLFormElement>(null)
  const kept = keptNames(list?.cues ?? [], typed)
  const removed = columns.filter(({ id }) => !typed.some((column) => column.id === id))
  const isChanged = JSON.stringify(typed) !== JSON.stringify(columns.map(typedOf))

  const put = (at: number, change: Partial<Typed>) => {
    setProblem(null)
    setTyped((now) => now.map((column, place) => (place === at ? { ...column, ...change } : column)))
  }
  const move = (at: number, by: 1 | -1) =>
    setTyped((now) => {
      const moved = now[at]
      if (moved === undefined) return now
      return now.filter((_, place) => place !== at).toSpliced(at + by, 0, moved)
    })
  const add = (column: Typed) => {
    setTyped((now) => [...now, column])
    requestAnimationFrame(() => form.current?.querySelector<HTMLInputElement>('li:last-child input')?.focus())
  }
  const save = async () => {
    if (set.isPending || !isChanged) return
    setProblem(null)
    try {
      const saved = await set.mutateAsync({ columns: typed.map(wantedOf), edition })
      draft.discard()
      showToast('Columns saved.', async () => {
        const there = new Set(saved.columns.map(({ id }) => id))
        const before = columns.map((column) => ({ ...column, id: there.has(column.id) ? column.id : null }))
        await set.mutateAsync({ columns: before, edition: saved.edition })
      })
    } catch (failure) {
      const refused = problemIn(failure)
      if (refused === null) throw failure
      setProblem(refused)
    }
  }
  useHotkeys([{ keys: 'mod+Enter', label: 'Save columns', group: 'Columns', run: () => void save() }])

  const faultOf = (place: number, field: string) =>
    problem?.errors.find(({ field: where }) => where === `column ${place + 1}: ${field}`)?.message

  return (
    <Card aria-labelledby="columns">
      <CardHead id="columns" title="Columns of this list" count={typed.length} />
      <form
        ref={form}
        className="grid justify-items-start gap-3 p-3-inset-4"
        onSubmit={(event) => {
          event.preventDefault()
          void save()
        }}
      >
        <DraftNote draft={draft} />
        <ol className={`grid w-full ${classes.columns}`}>
          {typed.map((column, at) => (
            <li key={column.id ?? `new ${at}`}>
              <ColumnFields
                column={column}
                place={at}
                faults={[faultOf(at, 'name'), faultOf(at, 'kind') ?? faultOf(at, 'choices')]}
                onChange={(change) => put(at, change)}
              />
              <span className={`flex gap-2px ${classes.acts}`}>
                <Button
                  variant="quiet"
                  aria-label={`Move ${column.name || 'the column'} up`}
                  disabled={at === 0}
                  onClick={() => move(at, -1)}
                >
                  Up
                </Button>
                <Button
                  variant="quiet"
                  aria-label={`Move ${column.name || 'the column'} down`}
                  disabled={at === typed.length - 1}
                  onClick={() => move(at, 1)}
                >
                  Down
                </Button>
                <Button
                  square
                  variant="quiet"
                  icon="cross"
                  aria-label={`Remove ${column.name || 'the column'}`}
                  onClick={() => setTyped((now) => now.filter((_, place) => place !== at))}
                />
              </span>
            </li>
          ))}
        </ol>
        {typed.length === 0 && <p className="mid">This list has no columns of its own yet.</p>}
        <p className="row wrap">
          <Button icon="plus" onClick={() => add(NEW)}>
            Add a column
          </Button>
          {kept.length > 0 && <span className="small mid">Values are kept under:</span>}
          {kept.map(([name, cues]) => (
            <Button key={name} onClick={() => add({ ...NEW, name })}>
              {`${name} (${plural(cues, 'cue')})`}
            </Button>
          ))}
        </p>
        {removed.length > 0 && (
          <p className="small mid" role="status">
            {removed.map(({ name }) => name).join(', ')} will be removed from the table. The values stay with the cues,
            and come back when you add a column of the same name.
          </p>
        )}
        <Refusal error={problem} />
        <Button type="submit" variant="primary" keys="mod+Enter" disabled={!isChanged || set.isPending}>
          Save columns
        </Button>
      </form>
    </Card>
  )
}

interface ColumnFieldsProps {
  column: Typed
  place: number
  faults: readonly [name: string | undefined, kind: string | undefined]
  onChange: (change: Partial<Typed>) => void
}

function ColumnFields({ column, place, faults: [nameFault, kindFault], onChange }: ColumnFieldsProps) {
  const id = `column-${place}`
  return (
    <span className={`grid gap-2-3 flex-1 narrow-grid-cols-1 ${classes.fields}`}>
      <label className={`grid gap-2px content-start ${classes.field}`}>
        <span className="small mid">Name</span>
        <input
          value={column.name}
          aria-invalid={nameFault !== undefined || undefined}
          aria-describedby={nameFault && `${id}-name`}
          onChange={(event) => onChange({ name: event.currentTarget.value })}
        />
        {nameFault && <FieldError id={`${id}-name`}>{nameFault}</FieldError>}
      </label>
      <span>
        <Select
          label="Type"
          value={column.kind}
          aria-describedby={kindFault && `${id}-kind`}
          onChange={(event) =>
            onChange({ kind: KINDS.find(({ value }) => value === event.currentTarget.value)?.value ?? 'text' })
          }
        >
          {KINDS.map(({ value, label }) => (
            <option key={value} value={value}>
              {label}
            </option>
          ))}
        </Select>
        {kindFault && <FieldError id={`${id}-kind`}>{kindFault}</FieldError>}
      </span>
      {column.kind === 'choice' && (
        <label className={`grid gap-2px content-start ${classes.field}`}>
          <span className="small mid">Choices, one a line</span>
          <textarea
            rows={3}
            value={column.choices}
            onChange={(event) => onChange({ choices: event.currentTarget.value })}
          />
        </label>
      )}
    </span>
  )
}
