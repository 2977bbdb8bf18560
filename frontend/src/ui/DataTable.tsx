import type { ReactNode } from 'react'

import classes from './DataTable.module.css'

export interface Column<T> {
  id: string
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
}

export interface RowGroup<T> {
  id: string
  head?: ReactNode
  rows: readonly T[]
}

interface DataTableProps<T> {
  /** What the table holds, for those who listen. */
  label: string
  columns: readonly Column<T>[]
  groups: readonly RowGroup<T>[]
  keyOf: (row: T) => string
  /** The selected row. */
  selected?: string
  /** Rows picked for doing one thing to all. */
  picked?: ReadonlySet<string>
  onSelect?: (row: T) => void
}

/** Dense rows of 26 px with hairlines; two lines a row on a narrow screen. The keys of the page move the selection. */
export function DataTable<T>({ label, columns, groups, keyOf, selected, picked, onSelect }: DataTableProps<T>) {
  return (
    <table className={classes.table} aria-label={label}>
      <colgroup>
        {columns.map(({ id, width }) => (
          <col key={id} style={{ width }} />
        ))}
      </colgroup>
      <thead>
        <tr>
          {columns.map(({ id, head, numeric }) => (
            <th key={id} scope="col" className={numeric ? 'num' : undefined}>
              {head}
            </th>
          ))}
        </tr>
      </thead>
      {groups.map((group) => (
        <tbody key={group.id}>
          {group.head !== undefined && (
            <tr className={classes.group}>
              <th scope="rowgroup" colSpan={columns.length}>
                {group.head}
              </th>
            </tr>
          )}
          {group.rows.map((row) => {
            const key = keyOf(row)
            return (
              // The row's link does the same by keyboard; a press anywhere on the row is only a shorter way.

              <tr
                key={key}
                data-selected={key === selected || undefined}
                data-picked={picked?.has(key) || undefined}
                aria-current={key === selected || undefined}
                onClick={onSelect && (() => onSelect(row))}
              >
                {columns.map(({ id, cell, numeric, narrow, rowHead }) => {
                  const Cell = rowHead ? 'th' : 'td'
                  return (
                    <Cell
                      key={id}
                      scope={rowHead ? 'row' : undefined}
                      data-narrow={narrow ?? 'none'}
                      className={numeric ? 'num' : undefined}
                    >
                      {cell(row)}
                    </Cell>
                  )
                })}
              </tr>
            )
          })}
        </tbody>
      ))}
    </table>
  )
}
