import { type QueryClient, useQueryClient } from '@tanstack/react-query'
import { type KeyboardEvent, useEffect, useRef, useState } from 'react'

import type { ApiProblem } from '@/api'
import { DraftNote, keepDraft, keptDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'

import classes from './AddCues.module.css'
import { type Cue, type CueAdd, problemIn, useAddCues } from '../api'
import { type CueDraft, type Faults, readDraft, refusedRows } from '../cue/draft'
import { useUndoAddition } from '../kits/api'
import { matrixQuery, isMatrix } from './matrix'
import { MatrixPreview } from './MatrixPreview'
import { blankRow, isBlank, isBlock, NEW_FIELDS, type NewRow, withPasted, ensureTrailingBlankRow } from './newRows'
import { NEEDS, SETTLED } from '../words'

type NewField = (typeof NEW_FIELDS)[number]

const HEADS: Record<NewField, string> = {
  name: 'Name',
  category: 'Category',
  use: 'Use in the game',
  description: 'Description',
  duration_s: 'Length, s',
  variations: 'Variations',
  loop: 'Loop',
  state: 'Design status',
  need: 'Need',
}

const keyOf = (projectId: string) => `new-cues:${projectId}`

interface AddCuesProps {
  projectId: string
  categories: readonly string[]
  /** What was looked for and not found. */
  name?: string
  onAdded: (cues: Cue[]) => void
  onClose: () => void
}

/** Several cues, typed like rows of a table, saved together. */
export function AddCues({ projectId, categories, name, onAdded, onClose }: AddCuesProps) {
  const [rows, setRowsOnly] = useState<NewRow[]>(() => {
    const typed = (keptDraft<CueDraft[]>(keyOf(projectId)) ?? []).map((draft) => ({ ...blankRow(), draft }))
    return ensureTrailingBlankRow(name ? [...typed, blankRow(name)] : typed)
  })
  const [wasKept, setWasKept] = useState(() => keptDraft(keyOf(projectId)) !== null)
  const [refusal, setRefusal] = useState<ApiProblem | null>(null)
  const add = useAddCues(projectId)
  const client = useQueryClient()
  const undo = useUndoAddition(projectId)
  const table = useRef<HTMLTableElement>(null)
  const filled = rows.filter((row) => !isBlank(row))
  const matrices = filled.filter(({ draft }) => isMatrix(draft.name))

  const setRows = (next: NewRow[]) => {
    setRowsOnly(next)
    const typed = next.filter((row) => !isBlank(row)).map(({ draft }) => draft)
    keepDraft(keyOf(projectId), typed.length > 0 ? typed : null)
  }
  const focusOn = (row: number, field: NewField) =>
    table.current?.querySelector<HTMLElement>(`[data-cell="${row} ${field}"]`)?.focus()
  useEffect(() => {
    const names = table.current?.querySelectorAll<HTMLElement>('[data-cell$=" name"]')
    names?.item(names.length - 1).focus()
  }, [])

  const put = (at: number, field: NewField, value: string | boolean) =>
    setRows(
      ensureTrailingBlankRow(
        rows.map((row, place) =>
          place === at ? { ...row, draft: { ...row.draft, [field]: value }, faults: {}, whole: [] } : row,
        ),
      ),
    )

  const save = async () => {
    if (add.isPending || filled.length === 0) return
    setRefusal(null)
    const read = await Promise.all(filled.map(({ draft }) => readRow(client, projectId, draft)))
    const faultsOf = new Map(filled.map(({ key }, at) => [key, read[at]?.faults ?? {}]))
    setRows(rows.map((row) => ({ ...row, faults: faultsOf.get(row.key) ?? {}, whole: [] })))
    if (read.some(({ faults }) => Object.keys(faults).length > 0)) return
    try {
      const added = await add.mutateAsync(read.flatMap(({ cues }) => cues))
      keepDraft(keyOf(projectId), null)
      const labels = [added[0]?.label, added.at(-1)?.label]
      const which = added.length > 1 ? `${labels[0]} to ${labels[1]}` : `${labels[0]} ${added[0]?.name}`
      showToast(`${plural(added.length, 'cue')} added: ${which}.`, () => undo.mutateAsync(added))
      onAdded(added)
    } catch (error) {
      const problem = problemIn(error)
      if (problem === null) throw error
      const refused = refusedRows(problem)
      const sources = read.flatMap(({ cues }, at) => cues.map(() => filled[at]?.key))
      const places = new Map([...refused].reverse().map(([at, against]) => [sources[at], against]))
      setRows(
        rows.map((row) => {
          const against = places.get(row.key)
          return { ...row, faults: against?.fields ?? {}, whole: against?.whole ?? [] }
        }),
      )
      if (refused.size === 0) setRefusal(problem)
    }
  }
  useHotkeys([{ keys: 'mod+Enter', label: 'Save new cues', group: 'List', run: () => void save() }])

  const goOn = (event: KeyboardEvent, at: number, field: NewField) => {
    if (event.key !== 'Enter' || event.ctrlKey || event.metaKey) return
    event.preventDefault()
    focusOn(at + 1, field)
  }
  const wrong = rows.filter((row) => Object.keys(row.faults).length + row.whole.length > 0).length

  return (
    <Card aria-labelledby="new-cues" className="mb-2">
      <CardHead
        id="new-cues"
        title="New cues"
        note="They are added at the end of the list. You can paste cells from a spreadsheet."
      />
      <DraftNote
        draft={{
          isRestored: wasKept,
          discard: () => {
            setWasKept(false)
            setRows(ensureTrailingBlankRow([]))
          },
        }}
      />
      <table ref={table} className={classes.table} aria-labelledby="new-cues">
        <thead>
          <tr>
            {NEW_FIELDS.map((field) => (
              <th key={field} scope="col" className={classes[field]}>
                {HEADS[field]}
              </th>
            ))}
            <th scope="col" className={classes.drop}>
              <span className="visually-hidden">Remove</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row, at) => (
            <tr key={row.key}>
              {NEW_FIELDS.map((field) => (
                <td key={field} data-head={HEADS[field]}>
                  <Cell
                    id={`new-${row.key}-${field}`}
                    cell={`${at} ${field}`}
                    label={`${HEADS[field]}, row ${at + 1}`}
                    field={field}
                    draft={row.draft}
                    fault={row.faults[field] ?? (field === 'name' ? againstName(row) : undefined)}
                    onChange={(value) => put(at, field, value)}
                    onKeyDown={(event) => goOn(event, at, field)}
                    onPaste={(text) => setRows(withPasted(rows, at, field, text))}
                  />
                </td>
              ))}
              <td className={classes.drop}>
                {!isBlank(row) && (
                  <Button
                    square
                    variant="quiet"
                    icon="cross"
                    aria-label={`Remove row ${at + 1}`}
                    onClick={() => setRows(ensureTrailingBlankRow(rows.filter(({ key }) => key !== row.key)))}
                  />
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {matrices.map(({ key, draft }) => (
        <MatrixPreview key={key} projectId={projectId} line={draft.name} category={draft.category} />
      ))}
      <datalist id="known-categories">
        {categories.map((category) => (
          <option key={category} value={category} />
        ))}
      </datalist>
      <Refusal error={refusal} />
      <footer className={`row wrap ${classes.foot}`}>
        <span className={wrong > 0 ? 'tone-bad toned' : 'small dim'} role="status">
          {wrong > 0
            ? `${plural(wrong, 'row')} with errors. Fix them to save; nothing you typed is lost.`
            : 'Press Enter for the next row. Only the name is required. “deck, sand × walk, run × 6” makes 4 cues of 6 variations.'}
        </span>
        <Button className="end" keys="Escape" onClick={onClose}>
          Close
        </Button>
        <Button
          variant="primary"
          keys="mod+Enter"
          disabled={filled.length === 0 || add.isPending}
          onClick={() => void save()}
        >
          {filled.length === 0 || matrices.length > 0 ? 'Add cues' : `Add ${plural(filled.length, 'cue')}`}
        </Button>
      </footer>
    </Card>
  )
}

interface ReadRow {
  /** What the row says: one cue, or all that its line makes. */
  cues: CueAdd[]
  faults: Faults
}

async function readRow(client: QueryClient, projectId: string, draft: CueDraft): Promise<ReadRow> {
  const { facts, faults } = readDraft(draft)
  if (Object.keys(faults).length > 0 || !isMatrix(draft.name)) return { cues: [facts], faults }
  try {
    const { rows } = await client.fetchQuery({ ...matrixQuery(projectId, draft.name, draft.category), staleTime: 0 })
    const variationsOf = (count: number) => (count > 1 ? count : facts.variations)
    return {
      cues: rows.map(({ name, file_name, variations }) => ({
        ...facts,
        name,
        file_name,
        variations: variationsOf(variations),
      })),
      faults,
    }
  } catch (error) {
    const problem = problemIn(error)
    if (problem === null) throw error
    return { cues: [], faults: { name: problem.detail } }
  }
}

/** What stands against a field that has no column here is said at the name. */
function againstName({ faults, whole }: NewRow): string | undefined {
  const others = Object.entries(faults).filter(([field]) => !(NEW_FIELDS as readonly string[]).includes(field))
  return [...whole, ...others.map(([, message]) => message)].join(' ') || undefined
}

interface CellProps {
  id: string
  cell: string
  label: string
  field: NewField
  draft: CueDraft
  fault: string | undefined
  onChange: (value: string | boolean) => void
  onKeyDown: (event: KeyboardEvent) => void
  onPaste: (text: string) => void
}

function Cell({ id, cell, label, field, draft, fault, onChange, onKeyDown, onPaste }: CellProps) {
  const shared = {
    'aria-label': label,
    'aria-invalid': fault !== undefined || undefined,
    'aria-describedby': fault === undefined ? undefined : id,
    'data-cell': cell,
  }
  return (
    <>
      {field === 'loop' ? (
        <input
          type="checkbox"
          className={classes.flag}
          checked={draft.loop}
          onChange={(event) => onChange(event.currentTarget.checked)}
          {...shared}
        />
      ) : field === 'state' || field === 'need' ? (
        <select
          className={classes.input}
          value={draft[field]}
          onChange={(event) => onChange(event.currentTarget.value)}
          {...shared}
        >
          {(field === 'state' ? SETTLED : NEEDS).map((option) => (
            <option key={option.value} value={option.value}>
              {option.label}
            </option>
          ))}
        </select>
      ) : (
        <input
          className={classes.input}
          value={draft[field]}
          list={field === 'category' ? 'known-categories' : undefined}
          inputMode={field === 'duration_s' ? 'decimal' : field === 'variations' ? 'numeric' : undefined}
          onChange={(event) => onChange(event.currentTarget.value)}
          onKeyDown={onKeyDown}
          onPaste={(event) => {
            const text = event.clipboardData.getData('text/plain')
            if (!isBlock(text)) return
            event.preventDefault()
            onPaste(text)
          }}
          {...shared}
        />
      )}
      {fault && <FieldError id={id}>{fault}</FieldError>}
    </>
  )
}
