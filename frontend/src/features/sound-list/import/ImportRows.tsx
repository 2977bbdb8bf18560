import { type KeyboardEvent, useCallback, useEffect, useMemo, useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day, figure } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Segmented } from '@/ui/Segmented'

import type { ImportRead } from './api'
import { Changes } from '../Changes'
import classes from './Import.module.css'
import { useVirtualRows } from '../useVirtualRows'

type Shown = 'all' | 'errors' | 'changes'
type Fault = ImportRead['errors'][number]

interface SheetRow {
  row: number
  read: ImportRead['rows'][number] | undefined
  faults: Fault[]
}

const rowPx = () => 28

/** Rows of the sheet in their order, each with what happens to it and what is wrong with it. */
function sheetRows(read: ImportRead): SheetRow[] {
  const rows = new Map<number, SheetRow>(read.rows.map((each) => [each.row, { row: each.row, read: each, faults: [] }]))
  for (const fault of read.errors) {
    const row = rows.get(fault.row) ?? { row: fault.row, read: undefined, faults: [] }
    row.faults.push(fault)
    rows.set(fault.row, row)
  }
  return [...rows.values()].sort((a, b) => a.row - b.row)
}

const WORDS = {
  add: { word: 'Add', icon: 'plus' },
  change: { word: 'Change', icon: 'pencil' },
  same: { word: 'Same', icon: 'tick' },
} as const

interface ImportRowsProps {
  read: ImportRead
  /** Leave a row out; it can be read again. */
  onSkip: (row: number) => void
  /** Put another text into a cell. */
  onEdit: (row: number, column: string, text: string) => void
  /** Give the empty cells of a column the value of the cell above. */
  onFillDown: (column: string) => void
}

/** Whether a key fills a column down, as in a spreadsheet. */
export const isFillDown = ({ key, ctrlKey, metaKey }: KeyboardEvent): boolean =>
  key.toLowerCase() === 'd' && (ctrlKey || metaKey)

/** What would happen to every row; F8 leads from error to error, x leaves the row of the focus out. */
export function ImportRows({ read, onSkip, onEdit, onFillDown }: ImportRowsProps) {
  const [current, setCurrent] = useState<number>()
  const all = useMemo(() => sheetRows(read), [read])
  const columns = useMemo(() => new Set(read.columns.map(({ name }) => name)), [read])
  const wrong = all.filter(({ faults }) => faults.length > 0).length
  const [wanted, setWanted] = useState<Shown>('all')
  const shown: Shown = wanted === 'errors' && wrong === 0 ? 'all' : wanted
  const rows = useMemo(
    () =>
      all.filter(
        (row) =>
          shown === 'all' || row.faults.length > 0 || (shown === 'changes' && row.read && row.read.action !== 'same'),
      ),
    [all, shown],
  )
  const table = useRef<HTMLTableElement>(null)
  const { places, beforePx, afterPx, measure } = useVirtualRows(
    rows.length,
    rowPx,
    useCallback((place: number) => String(rows[place]?.row), [rows]),
    table,
  )
  const wrongRows = all.filter(({ faults }) => faults.length > 0).map(({ row }) => row)
  const toNextError = () => {
    const next = wrongRows.find((row) => row > (current ?? 0)) ?? wrongRows[0]
    if (next === undefined) return
    setWanted('errors')
    setCurrent(next)
  }
  useEffect(() => {
    const line = table.current?.querySelector<HTMLElement>(`[data-row="${current}"]`)
    if (!line?.contains(document.activeElement)) line?.focus() // a cell of it may have the focus already
    line?.scrollIntoView({ block: 'nearest' })
  }, [current, shown])
  const skipCurrent = () => {
    if (current === undefined || !wrongRows.includes(current)) return
    onSkip(current)
    setCurrent(undefined)
  }
  useHotkeys([
    { keys: 'F8', label: 'Next error', group: 'Import', run: toNextError, disabled: wrong === 0 },
    { keys: 'x', label: 'Skip the row', group: 'Import', run: skipCurrent, disabled: current === undefined },
  ])
  return (
    <Card aria-labelledby="rows">
      <CardHead
        id="rows"
        title="Preview"
        count={all.length}
        end={
          <>
            {wrong > 0 && (
              <Button keys="F8" onClick={toNextError}>
                Next error
              </Button>
            )}
            <Segmented
              label="Rows shown"
              value={shown}
              onChange={setWanted}
              options={[
                { value: 'all', label: 'All' },
                { value: 'changes', label: 'Changes' },
                ...(wrong > 0 ? [{ value: 'errors' as const, label: `${wrong} with errors` }] : []),
              ]}
            />
          </>
        }
      />
      <table ref={table} className={classes.rows} aria-label="Rows of the spreadsheet" aria-rowcount={rows.length + 1}>
        <thead>
          <tr>
            <th scope="col" className={`num ${classes.rowNumber}`}>
              Row
            </th>
            <th scope="col" className={classes.action}>
              Action
            </th>
            <th scope="col" className={classes.label}>
              ID
            </th>
            <th scope="col" className={classes.cue}>
              Cue
            </th>
            <th scope="col" className={classes.category}>
              Category
            </th>
            <th scope="col" className={`num ${classes.length}`}>
              Length, s
            </th>
            <th scope="col">Changes or errors</th>
          </tr>
        </thead>
        <tbody>
          {beforePx > 0 && <Gap heightPx={beforePx} />}
          {places.map((at) => {
            const row = rows[at]
            return (
              row && (
                <Line
                  key={row.row}
                  row={row}
                  at={at}
                  measure={measure}
                  isCurrent={row.row === current}
                  onFocus={() => setCurrent(row.row)}
                  onSkip={() => onSkip(row.row)}
                  columns={columns}
                  onEdit={onEdit}
                  onFillDown={onFillDown}
                />
              )
            )
          })}
          {afterPx > 0 && <Gap heightPx={afterPx} />}
        </tbody>
      </table>
    </Card>
  )
}

function Gap({ heightPx }: { heightPx: number }) {
  return (
    <tr aria-hidden="true">
      <td colSpan={7} style={{ height: heightPx, padding: 0, border: 0 }} />
    </tr>
  )
}

interface LineProps extends Pick<ImportRowsProps, 'onEdit' | 'onFillDown'> {
  row: SheetRow
  /** The columns that the sheet has: a missing one has no cell to repair. */
  columns: ReadonlySet<string>
  at: number
  measure: ((row: Element | null) => void) | undefined
  isCurrent: boolean
  onFocus: () => void
  onSkip: () => void
}

function Line({
  row: { row, read, faults },
  columns,
  at,
  measure,
  isCurrent,
  onFocus,
  onSkip,
  onEdit,
  onFillDown,
}: LineProps) {
  const action = read && WORDS[read.action]
  const isWrong = faults.length > 0
  return (
    <tr
      ref={measure}
      data-index={at}
      data-row={row}
      data-wrong={isWrong || undefined}
      aria-rowindex={at + 2}
      tabIndex={isCurrent ? 0 : -1}
      onFocus={onFocus}
    >
      <td className="num mono dim">{row}</td>
      <td>
        {isWrong ? (
          <span className="row tone-bad toned">
            <Icon name="back" /> Error
          </span>
        ) : (
          action && (
            <span className={read.action === 'same' ? 'row dim' : 'row'}>
              <Icon name={action.icon} /> {action.word}
            </span>
          )
        )}
      </td>
      <td className="mono dim">{read?.label ?? ''}</td>
      <th scope="row" className={classes.cue}>
        {read?.name ?? faults[0]?.name}
      </th>
      <td className="mid">{read?.category}</td>
      <td className="num">{read?.duration_s == null ? '' : figure(read.duration_s, 2)}</td>
      <td className="wrap-anywhere">
        {faults.map((fault, place) => (
          <div key={place} className="row wrap tone-bad">
            {fault.column && <span className="strong">{fault.column}: </span>}
            {fault.column && columns.has(fault.column) && (
              <CellField
                key={fault.text}
                fault={fault}
                onEdit={(text) => onEdit(row, fault.column ?? '', text)}
                onFillDown={() => onFillDown(fault.column ?? '')}
              />
            )}
            <span className="toned">{fault.message}</span>
          </div>
        ))}
        {isWrong && (
          <Button variant="quiet" className="small" keys={isCurrent ? 'x' : undefined} onClick={onSkip}>
            Skip row {row}
          </Button>
        )}
        {!isWrong && read && read.action === 'change' && <Changes changes={read.changes} />}
        {!isWrong && read?.action === 'add' && (
          <span className="mid">
            {[read.due_on && `Needed by ${day(read.due_on)}`, read.description].filter(Boolean).join('. ')}
          </span>
        )}
      </td>
    </tr>
  )
}

interface CellFieldProps {
  fault: Fault
  onEdit: (text: string) => void
  onFillDown: () => void
}

/** A wrong cell, repaired in place: Enter or leaving it reads the sheet again, Ctrl D fills its column down. */
function CellField({ fault: { row, column, text }, onEdit, onFillDown }: CellFieldProps) {
  const keep = (typed: string) => typed !== text && onEdit(typed)
  return (
    <input
      className={classes.cell}
      aria-label={`${column}, row ${row}`}
      aria-keyshortcuts="Enter Control+D Meta+D"
      aria-invalid="true"
      defaultValue={text}
      maxLength={10_000}
      onBlur={({ currentTarget }) => keep(currentTarget.value)}
      onKeyDown={(event) => {
        if (event.key === 'Enter' && !event.ctrlKey && !event.metaKey) {
          event.preventDefault()
          keep(event.currentTarget.value)
        }
        if (event.key === 'Escape') {
          event.stopPropagation()
          event.currentTarget.value = text
        }
        if (isFillDown(event)) {
          event.preventDefault()
          onFillDown()
        }
      }}
    />
  )
}
