import { bytes, figure } from '@/ui/format'
import { Table } from '@/ui/Table'

import type { Target } from './api'
import classes from './Files.module.css'
import { roomOf } from './words'

/** What a target takes in memory, by category: dark what is there, pale what the list will add, a line for the budget. */
export function MemoryBars({ target }: { target: Target }) {
  const { used, forecast } = target
  const there = new Map(used.categories.map((row) => [row.category, row]))
  const rows = [
    { name: 'all', of: forecast.total, used: used.total },
    ...forecast.categories.map((row) => ({
      name: row.category ?? 'no category',
      of: row,
      used: there.get(row.category),
    })),
  ]
  if (forecast.total.files + forecast.total.unknown_files === 0) {
    return <p className="small mid">The sound list is empty, so there is no memory use to show.</p>
  }
  const longest = Math.max(1, ...rows.flatMap(({ of }) => [of.memory_bytes, of.budget_bytes ?? 0]))
  const share = (count: number) => `${(count / longest) * 100}%`
  return (
    <>
      <div
        role="img"
        aria-label={`Memory of ${target.name}: ${rows.map(({ name, of }) => `${name} ${roomOf(of)}`).join('; ')}`}
      >
        {rows.map(({ name, of, used: now }) => (
          <div key={name} className={`grid items-center gap-3 narrow-grid-cols-1-auto ${classes.bar} small`}>
            <span className="cut-text">{name}</span>
            <span className={`bg-well relative border rounded-2px ${classes.track}`}>
              <i style={{ width: share(of.memory_bytes) }} />
              <i data-used="" style={{ width: share(Math.min(now?.memory_bytes ?? 0, of.memory_bytes)) }} />
              {of.budget_bytes !== null && <i data-budget="" style={{ left: share(of.budget_bytes) }} />}
            </span>
            <span className={of.over_bytes !== null && of.over_bytes > 0 ? 'num tone-bad toned' : 'num mid'}>
              {roomOf(of)}
            </span>
          </div>
        ))}
      </div>
      <p className={`small mid flex wrap gap-2px-4 ${classes.legend}`}>
        <span>
          <i data-used="" /> accepted
        </span>
        <span>
          <i /> with the rest of the list
        </span>
        {rows.some(({ of }) => of.budget_bytes !== null) && (
          <span>
            <i data-budget="" /> budget
          </span>
        )}
      </p>
      <details className="small">
        <summary className="pointer min-h-24px">Show as table</summary>
        <Table
          label={`Memory of ${target.name} by category`}
          rows={rows}
          keyOf={({ name }) => name}
          columns={[
            { head: 'Category', rowHead: true, cell: ({ name }) => name },
            { head: 'Files', numeric: true, cell: ({ of }) => figure(of.files) },
            { head: 'Without a length', numeric: true, cell: ({ of }) => figure(of.unknown_files) },
            { head: 'Used', numeric: true, cell: ({ used: now }) => bytes(now?.memory_bytes ?? 0) },
            { head: 'Forecast', numeric: true, cell: ({ of }) => bytes(of.memory_bytes) },
            { head: 'On disk', numeric: true, cell: ({ of }) => bytes(of.disk_bytes) },
            {
              head: 'Budget',
              numeric: true,
              cell: ({ of }) => (of.budget_bytes === null ? 'none' : bytes(of.budget_bytes)),
            },
          ]}
        />
      </details>
    </>
  )
}
