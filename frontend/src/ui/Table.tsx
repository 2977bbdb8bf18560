import type { ReactNode } from 'react'

import classes from './Table.module.css'

export interface Column<T> {
  id?: string
  head: ReactNode
  cell: (row: T) => ReactNode
  /** A CSS width for the fixed layout: "96px", "18%". */
  width?: string
  numeric?: boolean
  /**
   * Where it goes under 760 px, where a row has two lines: name and state above, set and what stands below.
   * Columns without a place are left out there.
   */
  narrow?: 'name' | 'state' | 'set' | 'stands'
  /** The cell that names the row for those who listen. */
  rowHead?: boolean
  /** Left out on a phone, in a table of figures. */
  wideOnly?: boolean
  className?: string
}

export interface RowGroup<T> {
  id: string
  head?: ReactNode
  rows: readonly T[]
}

interface TableProps<T> {
  /** What the table holds, for those who listen. */
  label: string
  columns: readonly Column<T>[]
  rows: readonly T[]
  keyOf: (row: T) => string | number
  rowClass?: (row: T) => string | undefined
}

/** Figures within a card: it scrolls sideways in itself, by keys too. */
export function Table<T>({ label, columns, rows, keyOf, rowClass }: TableProps<T>) {
  return (
    // A region that scrolls is reached by the keyboard.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-tabindex
    <div className="overflow-x-auto" role="region" aria-label={label} tabIndex={0}>
      <table className={`small ${classes.figures}`} aria-label={label}>
        <Heads columns={columns} />
        <tbody>
          {rows.map((row) => (
            <tr key={keyOf(row)} className={rowClass?.(row)}>
              <Cells columns={columns} row={row} />
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  )
}

const classOf = <T,>({ numeric, wideOnly, className }: Column<T>) =>
  [numeric ? 'num' : '', wideOnly ? 'wide-only' : '', className ?? ''].filter(Boolean).join(' ') || undefined

function Heads<T>({ columns }: { columns: readonly Column<T>[] }) {
  return (
    <thead>
      <tr>
        {columns.map((column, at) => (
          <th key={column.id ?? at} scope="col" className={classOf(column)}>
            {column.head}
          </th>
        ))}
      </tr>
    </thead>
  )
}

function Cells<T>({ columns, row }: { columns: readonly Column<T>[]; row: T }) {
  return columns.map((column, at) => {
    const Cell = column.rowHead ? 'th' : 'td'
    return (
      <Cell
        key={column.id ?? at}
        scope={column.rowHead ? 'row' : undefined}
        data-narrow={column.narrow ?? 'none'}
        className={classOf(column)}
      >
        {column.cell(row)}
      </Cell>
    )
  })
}

interface ListTableProps<T> extends Omit<TableProps<T>, 'rows' | 'rowClass'> {
  groups: readonly RowGroup<T>[]
  /** The selected row. */
  selected?: string
  onSelect?: (row: T) => void
}

/** Dense rows of 26 px with hairlines; two lines a row on a narrow screen. The keys of the page move the selection. */
export function ListTable<T>({ label, columns, groups, keyOf, selected, onSelect }: ListTableProps<T>) {
  return (
    <table className={`bg-raised overflow-hidden border rounded-l ${classes.table}`} aria-label={label}>
      <colgroup>
        {columns.map(({ id, width }, at) => (
          <col key={id ?? at} style={{ width }} />
        ))}
      </colgroup>
      <Heads columns={columns} />
      {groups.map((group) => (
        <tbody key={group.id}>
          {group.head !== undefined && (
            <tr className={classes.group}>
              <th scope="rowgroup" colSpan={columns.length}>
                {group.head}
              </th>
            </tr>
          )}
          {group.rows.map((row) => (
            // The row's link does the same by keyboard; a press anywhere on the row is only a shorter way.
            <tr
              key={keyOf(row)}
              data-selected={keyOf(row) === selected || undefined}
              aria-current={keyOf(row) === selected || undefined}
              onClick={onSelect && (() => onSelect(row))}
            >
              <Cells columns={columns} row={row} />
            </tr>
          ))}
        </tbody>
      ))}
    </table>
  )
}
