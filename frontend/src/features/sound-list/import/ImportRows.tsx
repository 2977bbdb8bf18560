import { type KeyboardEvent, type ReactNode, useCallback, useEffect, useMemo, useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Segmented } from '@/ui/Segmented'

import type { ImportRead } from './api'
import { Changes } from '../Changes'
import classes from './Import.module.css'
import { useVirtualRows } from '../useVirtualRows'

type Shown = 'all' | 'errors' | 'changes'
type Fault = ImportRead['errors'][number]

type Skipped = ImportRead['skipped'][number]
type Guess = ImportRead['guesses'][number]

interface SheetRow {
  row: number
  cells: readonly string[]
  read: ImportRead['rows'][number] | undefined
  skipped: Skipped | undefined
  faults: Fault[]
  guesses: Guess[]
  /** The file name that the spec accepts, where it refuses that of the row. */
  proposed: string | null
}

const rowPx = () => 28

/** Rows of the sheet in their order, each with what happens to it and what is wrong with it. */
function sheetRows(read: ImportRead): SheetRow[] {
  const rows = new Map<number, SheetRow>()
  const at = (row: number): SheetRow => {
    const kept = rows.get(row) ?? {
      row,
      cells: [],
      read: undefined,
      skipped: undefined,
      faults: [],
      guesses: [],
      proposed: null,
    }
    rows.set(row, kept)
    return kept
  }
  for (const { row, cells } of read.cells) at(row).cells = cells
  for (const line of read.rows) at(line.row).read = line
  for (const line of read.skipped) at(line.row).skipped = line
  for (const fault of read.errors) at(fault.row).faults.push(fault)
  for (const guess of read.guesses) at(guess.row).guesses.push(guess)
  for (const { row, proposed } of read.refused_names.names) if (row !== null) at(row).proposed = proposed
  return [...rows.values()].sort((a, b) => a.row - b.row)
}

const WORDS = {
  add: { word: 'Add', icon: 'plus' },
  change: { word: 'Change', icon: 'pencil' },
  same: { word: 'Same', icon: 'tick' },
} as const

const KINDS: Record<Skipped['kind'], string> = {
  section: 'Section',
  total: 'Total',
  head: 'Head',
  note: 'Note',
  hidden: 'Hidden',
  asked: 'Skipped by you',
}

interface ImportRowsProps {
  read: ImportRead
  /** What a column is read as, chosen in its head. */
  head: (column: ImportRead['columns'][number]) => ReactNode
  /** How rows find their cues. */
  match: ReactNode
  /** Read a row that was left out as a cue. */
  onKeep: (row: Skipped) => void
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
export function ImportRows({ read, head, match, onKeep, onSkip, onEdit, onFillDown }: ImportRowsProps) {
  const [current, setCurrent] = useState<number>()
  const all = useMemo(() => sheetRows(read), [read])
  const known = read.columns.filter(({ field }) => field !== 'extra' && field !== 'ignore').length
  const wrong = all.filter(({ faults }) => faults.length > 0).length
  const [chosen, setChosen] = useState<Shown>('all')
  const shown: Shown = chosen === 'errors' && wrong === 0 ? 'all' : chosen
  const rows = useMemo(
    () =>
      all.filter(
        (row) =>
          shown === 'all' ||
          row.faults.length > 0 ||
          (shown === 'changes' && row.skipped === undefined && row.read?.action !== 'same'),
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
    setChosen('errors')
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
        title="Rows"
        count={all.length}
        note={`${known} of ${plural(read.columns.length, 'column')} mapped${read.header_row === null ? '; no header row' : ''}`}
        end={
          <span className="row wrap">
            {match}
            {wrong > 0 && (
              <Button keys="F8" onClick={toNextError}>
                Next error
              </Button>
            )}
            <Segmented
              label="Rows shown"
              value={shown}
              onChange={setChosen}
              options={[
                { value: 'all', label: 'All' },
                { value: 'changes', label: 'Changes' },
                ...(wrong > 0 ? [{ value: 'errors' as const, label: `${wrong} with errors` }] : []),
              ]}
            />
          </span>
        }
      />
      {/* What scrolls is reached by the keyboard too. */}
      {/* eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex */}
      <div className="overflow-x-auto rounded-b-l" tabIndex={0} role="group" aria-label="Sheet">
        <table
          ref={table}
          className={`w-full ${classes.rows}`}
          aria-label="Rows of the spreadsheet"
          aria-rowcount={rows.length + 1}
        >
          <thead>
            <tr>
              <th scope="col" className={`num ${classes.rowNumber}`}>
                Row
              </th>
              <th scope="col" className={classes.action}>
                Action
              </th>
              {read.columns.map((column) => (
                <th key={column.name} scope="col" data-own={isKept(column.field) || undefined}>
                  {head(column)}
                </th>
              ))}
              <th scope="col" className={classes.why}>
                Changes
              </th>
            </tr>
          </thead>
          <tbody>
            {beforePx > 0 && <Gap heightPx={beforePx} columns={read.columns.length + 3} />}
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
                    columns={read.columns}
                    onKeep={onKeep}
                    onEdit={onEdit}
                    onFillDown={onFillDown}
                  />
                )
              )
            })}
            {afterPx > 0 && <Gap heightPx={afterPx} columns={read.columns.length + 3} />}
          </tbody>
        </table>
      </div>
    </Card>
  )
}

const faultText = ({ column, message }: Fault) => (
  <p key={`${column} ${message}`} className="small tone-bad toned">
    {message}
  </p>
)
const isKept = (field: string) => field === 'extra' || field === 'ignore'

function Gap({ heightPx, columns }: { heightPx: number; columns: number }) {
  return (
    <tr aria-hidden="true">
      <td colSpan={columns} style={{ height: heightPx, padding: 0, border: 0 }} />
    </tr>
  )
}

interface LineProps extends Pick<ImportRowsProps, 'onEdit' | 'onFillDown' | 'onKeep'> {
  row: SheetRow
  columns: ImportRead['columns']
  at: number
  measure: ((row: Element | null) => void) | undefined
  isCurrent: boolean
  onFocus: () => void
  onSkip: () => void
}

function Line({ row, columns, at, measure, isCurrent, onFocus, onSkip, onKeep, onEdit, onFillDown }: LineProps) {
  const { read, skipped, faults, guesses } = row
  const action = read && WORDS[read.action]
  const isWrong = faults.length > 0
  const nameColumn = columns.find(({ field }) => field === 'name') ?? columns.find(({ field }) => field === 'file_name')
  const outside = faults.filter(({ column }) => !columns.some(({ name }) => name === column))
  return (
    <tr
      ref={measure}
      data-index={at}
      data-row={row.row}
      data-wrong={isWrong || undefined}
      data-skipped={skipped?.kind}
      aria-rowindex={at + 2}
      tabIndex={isCurrent ? 0 : -1}
      onFocus={onFocus}
    >
      <td className="num mono dim">{row.row}</td>
      <td>
        {isWrong ? (
          <>
            <span className="row tone-bad toned">
              <Icon name="back" /> Error
            </span>
            <Button
              variant="quiet"
              className="small"
              keys={isCurrent ? 'x' : undefined}
              aria-label={`Skip row ${row.row}`}
              onClick={onSkip}
            >
              Skip
            </Button>
          </>
        ) : skipped ? (
          <span className="row dim">{KINDS[skipped.kind]}</span>
        ) : (
          action && (
            <span className={read.action === 'same' ? 'row dim' : 'row'}>
              <Icon name={action.icon} /> {action.word}
            </span>
          )
        )}
      </td>
      {skipped ? (
        <td className={classes.skipped} colSpan={columns.length}>
          <span data-struck={skipped.kind === 'total' || skipped.kind === 'asked' || undefined}>{skipped.text}</span>{' '}
          <span className="small dim">{skipped.why}</span>{' '}
          <Button
            variant="quiet"
            className="small"
            aria-label={`Read row ${row.row} as a cue`}
            onClick={() => onKeep(skipped)}
          >
            Read as a cue
          </Button>
        </td>
      ) : (
        columns.map((column, place) => (
          <Cell
            key={column.name}
            row={row}
            column={column}
            text={row.cells[place] ?? ''}
            isName={column === nameColumn}
            fault={faults.find(({ column: name }) => name === column.name)}
            below={column === nameColumn && outside.length > 0 ? outside.map(faultText) : null}
            guess={guesses.find(({ column: name }) => name === column.name)}
            onEdit={onEdit}
            onFillDown={onFillDown}
          />
        ))
      )}
      <td className={`wrap-anywhere ${classes.why}`}>
        {read?.label && <span className="mono dim">{read.label} </span>}
        {!nameColumn && outside.map(faultText)}
        {!isWrong && read?.action === 'change' && <Changes changes={read.changes} />}
      </td>
    </tr>
  )
}

interface CellProps extends Pick<ImportRowsProps, 'onEdit' | 'onFillDown'> {
  row: SheetRow
  column: ImportRead['columns'][number]
  text: string
  /** Whether the row is called by this cell. */
  isName: boolean
  fault: Fault | undefined
  /** What is wrong with the row and with none of its cells. */
  below: ReactNode
  guess: Guess | undefined
}

/** A cell as the sheet has it, what it is read as where that is a guess, and its repair. */
function Cell({ row, column, text, isName, fault, below, guess, onEdit, onFillDown }: CellProps) {
  const proposed = isName ? row.proposed : null
  const value = proposed ?? (guess && guess.kind !== 'filled_down' && guess.value !== text ? guess.value : null)
  const shown = fault ? (
    <>
      <CellField
        key={fault.text}
        fault={fault}
        onEdit={(typed) => onEdit(row.row, column.name, typed)}
        onFillDown={() => onFillDown(column.name)}
      />
      {faultText(fault)}
    </>
  ) : (
    <>
      {text || (isName && (row.read?.name ?? row.faults[0]?.name))}
      {value !== null && (
        <span className={proposed ? 'tone-warn toned' : 'mid'}>
          {' → '}
          <span className="strong">{value === '' ? 'empty' : value}</span>
        </span>
      )}
    </>
  )
  const shared = {
    'data-own': isKept(column.field) || undefined,
    'data-filled': guess?.kind === 'filled_down' || undefined,
    'data-wrong': fault ? true : undefined,
    title: fault ? undefined : [text, guess?.why].filter(Boolean).join('\n') || undefined,
  }
  return isName ? (
    <th scope="row" {...shared}>
      {shown}
      {below}
    </th>
  ) : (
    <td data-cell {...shared}>
      {shown}
    </td>
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
      className={`rounded-s bg-raised ink font-inherit ${classes.cell}`}
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
