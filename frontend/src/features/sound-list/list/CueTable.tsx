import { Link } from '@tanstack/react-router'
import { memo, type MouseEvent, type ReactNode, useCallback, useEffect, useMemo, useRef } from 'react'

import { WaveThumb } from '@/audio'
import { NotHeard } from '@/heard/NotHeard'
import { lengthAsked } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { NeedMark } from '@/ui/NeedMark'
import { SetBlocks } from '@/ui/SetBlocks'
import { StatusBadge } from '@/ui/StatusBadge'

import type { OwnColumn } from '../columns/api'
import { ValueCell } from '../columns/ValueCell'
import classes from './CueTable.module.css'
import { TASKS } from '../people'
import { blocksOf, type CueRow, type Group } from '../rows'
import { useVirtualRows } from '../useVirtualRows'

const STATE_COLUMNS = 10
const CONTENT_COLUMNS = 8 // besides the project's own
const ROW_PX = 26
const NARROW_ROW_PX = 56
const HEAD_PX = 25
const OPEN_PX = 280
const MANY_VARIATIONS = 6
const FIXED_PX = 1000
const OWN_PX = 132
const MOST_ON_SCREEN = 4 // own columns, beyond which the table scrolls sideways

/** One line of the table: a heading, a cue, or what is open below a cue. */
type Item = { key: string; group?: Group; row?: CueRow }

function itemsOf(groups: readonly Group[], openId: string | undefined): Item[] {
  const headed = groups.length > 1
  return groups.flatMap((group) => [
    ...(headed ? [{ key: group.id, group }] : []),
    ...group.rows.flatMap((row) => [{ key: row.id, row }, ...(row.id === openId ? [{ key: `open ${row.id}` }] : [])]),
  ])
}

interface CueTableProps {
  groups: readonly Group[]
  projectId: string
  selectedId: string | null
  picked: ReadonlySet<string>
  mayPick: boolean
  playingId: string | null
  /** The project's own columns where the table shows what the cues are; null where it shows where they stand. */
  columns: readonly OwnColumn[] | null
  /** Names by id where the table shows who puts cues in the game and records them. */
  people: ReadonlyMap<string, string> | null
  /** What is open below a row: its fields, its questions. */
  open: { id: string; inside: ReactNode } | null
  onSelect: (id: string) => void
  onPick: (id: string, extend: boolean) => void
  onPlay: (row: CueRow) => void
  /** Answer what is unclear about a cue; missing for those who only read. */
  onClarify?: (id: string) => void
}

/** The list: dense rows under headings; two lines a row on a narrow screen. */
export function CueTable(props: CueTableProps) {
  const { groups, projectId, selectedId, picked, mayPick, playingId, open, onSelect, onPick, onPlay, onClarify } = props
  const table = useRef<HTMLTableElement>(null)
  const openId = open?.id
  const items = useMemo(() => itemsOf(groups, openId), [groups, openId])
  const places = useMemo(() => new Map(items.map(({ key }, place) => [key, place])), [items])
  const narrow = window.matchMedia('(max-width: 760px)').matches
  const columns = narrow ? null : props.columns
  const people = columns === null ? null : props.people
  const added = columns === null ? 0 : columns.length + (people === null ? 0 : TASKS.length)
  const scrolls = added > MOST_ON_SCREEN
  const estimate = useCallback(
    (place: number) => {
      const item = items[place]
      if (item?.group) return HEAD_PX
      return item?.row ? (narrow ? NARROW_ROW_PX : ROW_PX) : OPEN_PX
    },
    [items, narrow],
  )
  const keyOf = useCallback((place: number) => items[place]?.key ?? String(place), [items])
  const drawn = useVirtualRows(items.length, estimate, keyOf, table)

  const shown = useRef<string | null>(selectedId)
  useEffect(() => {
    if (selectedId === null || selectedId === shown.current) return
    shown.current = selectedId
    drawn.scrollTo(places.get(selectedId) ?? 0)
    // A row far away is drawn only after the scroll.
    const focus = () => {
      const row = table.current?.querySelector<HTMLElement>(`tr[data-row="${selectedId}"]`)
      if (!row || row.contains(document.activeElement)) return
      row.focus({ preventScroll: true })
      row.scrollIntoView({ block: 'nearest' })
    }
    focus()
    const frame = requestAnimationFrame(focus)
    return () => cancelAnimationFrame(frame)
  })

  useEffect(() => {
    if (openId !== undefined) table.current?.querySelector('tr[data-open]')?.scrollIntoView({ block: 'nearest' })
  }, [openId])

  const width = columns === null ? STATE_COLUMNS : CONTENT_COLUMNS + added
  const drawnTable = (
    <table
      ref={table}
      className={`bg-raised border rounded-l ${classes.table}`}
      style={scrolls ? { width: `max(100%, ${FIXED_PX + added * OWN_PX}px)` } : undefined}
      data-scrolls={scrolls || undefined}
      aria-label="Sound list"
      aria-rowcount={items.length + 1}
    >
      <colgroup>
        <col className={classes.numberColumn} />
        <col className={classes.nameColumn} />
        <col className={classes.needColumn} />
        <col className={classes.categoryColumn} />
        <col className={classes.useColumn} />
        <col className={classes.lengthColumn} />
        <col className={classes.setColumn} />
        {columns === null ? (
          <>
            <col className={classes.waveColumn} />
            <col className={classes.stateColumn} />
          </>
        ) : (
          Array.from({ length: added }, (_, at) => <col key={at} className={classes.ownColumn} />)
        )}
        <col />
      </colgroup>
      <thead>
        <tr>
          <th scope="col">ID</th>
          <th scope="col">Cue</th>
          <th scope="col">Need</th>
          <th scope="col">Category</th>
          <th scope="col">Use in the game</th>
          <th scope="col" className="num">
            Length, s
          </th>
          <th scope="col">Set or loop</th>
          {columns === null ? (
            <>
              <th scope="col">Latest version</th>
              <th scope="col">State</th>
              <th scope="col">Latest</th>
            </>
          ) : (
            <>
              {people !== null &&
                TASKS.map(({ task, label }) => (
                  <th key={task} scope="col">
                    {label}
                  </th>
                ))}
              {columns.map(({ id, name, kind }) => (
                <th key={id} scope="col" className={kind === 'number' ? 'num' : undefined} title={name}>
                  {name}
                </th>
              ))}
              <th scope="col">Description</th>
            </>
          )}
        </tr>
      </thead>
      <tbody>
        {drawn.beforePx > 0 && <Gap heightPx={drawn.beforePx} columns={width} />}
        {drawn.places.map((at) => {
          const item = items[at]
          if (item === undefined) return null
          if (item.group) {
            return (
              <tr key={item.key} className={classes.group} data-index={at} ref={drawn.measure} aria-rowindex={at + 2}>
                <th colSpan={width} scope="colgroup">
                  <span className={`strong ink ${classes.groupName}`}>{item.group.name}</span>{' '}
                  <span className="small dim">{item.group.note}</span>
                </th>
              </tr>
            )
          }
          const { row } = item
          if (row === undefined) {
            return (
              <tr key={item.key} className={classes.open} data-index={at} data-open ref={drawn.measure}>
                <td colSpan={width}>{open?.inside}</td>
              </tr>
            )
          }
          return (
            <Line
              key={item.key}
              row={row}
              projectId={projectId}
              at={at}
              selected={row.id === selectedId}
              picked={picked.has(row.id)}
              picking={picked.size > 0}
              mayPick={mayPick}
              playing={row.id === playingId}
              columns={columns}
              people={people}
              onSelect={onSelect}
              onPick={onPick}
              onPlay={onPlay}
              onClarify={onClarify}
              measure={drawn.measure}
            />
          )
        })}
        {drawn.afterPx > 0 && <Gap heightPx={drawn.afterPx} columns={width} />}
      </tbody>
    </table>
  )
  return scrolls ? <div className={`overflow-x-auto ${classes.scrolls}`}>{drawnTable}</div> : drawnTable
}

function Gap({ heightPx, columns }: { heightPx: number; columns: number }) {
  return (
    <tr aria-hidden="true" className={classes.gap}>
      <td colSpan={columns} style={{ height: heightPx }} />
    </tr>
  )
}

interface LineProps {
  row: CueRow
  projectId: string
  at: number
  selected: boolean
  picked: boolean
  picking: boolean
  mayPick: boolean
  playing: boolean
  columns: readonly OwnColumn[] | null
  people: ReadonlyMap<string, string> | null
  onSelect: (id: string) => void
  onPick: (id: string, extend: boolean) => void
  onPlay: (row: CueRow) => void
  onClarify: ((id: string) => void) | undefined
  measure: ((row: Element | null) => void) | undefined
}

const Line = memo(function Line(props: LineProps) {
  const {
    row,
    projectId,
    at,
    selected,
    picked,
    picking,
    mayPick,
    playing,
    columns,
    people,
    onSelect,
    onPick,
    onPlay,
    onClarify,
    measure,
  } = props
  const { cue } = row
  const press = (event: MouseEvent) => {
    if (mayPick && (event.ctrlKey || event.metaKey || event.shiftKey)) {
      event.preventDefault()
      onPick(row.id, event.shiftKey)
    } else onSelect(row.id)
  }
  const name = row.status === 'cut' ? 'struck' : row.needsSomeone ? 'strong' : ''
  return (
    // The row's link and its keys do the same; a press anywhere on the row is only a shorter way.
    <tr
      ref={measure}
      data-index={at}
      data-row={row.id}
      data-selected={selected || undefined}
      data-picked={picked || undefined}
      aria-current={selected || undefined}
      aria-rowindex={at + 2}
      tabIndex={-1}
      onClick={press}
    >
      <td className="mono dim" data-place="number">
        {mayPick && (
          <input
            type="checkbox"
            className={`absolute m-0 pointer ${classes.pick}`}
            data-shown={picking || undefined}
            aria-label={`Select ${cue.label}`}
            checked={picked}
            onClick={(event) => event.stopPropagation()}
            onChange={(event) => onPick(row.id, (event.nativeEvent as unknown as MouseEvent).shiftKey)}
          />
        )}
        {cue.label}
      </td>
      <th scope="row" data-place="name" data-marked={row.isUnheard || undefined}>
        <Link
          to="/projects/$projectId/sound-list/cues/$cueId"
          params={{ projectId, cueId: cue.id }}
          className={`${classes.name} ${name}`}
        >
          {cue.name}
        </Link>
        {row.isUnheard && <NotHeard />}
      </th>
      <td className="small">
        {row.status === 'cut' ? <span className="dim">cut</span> : <NeedMark need={cue.need} />}
      </td>
      <td className="mid">{cue.category}</td>
      <td className="mid" title={cue.use}>
        {cue.use}
      </td>
      <td className="num">{lengthAsked(cue).replace(/ s$/, '')}</td>
      <td className="small mid" data-place="set">
        <SetOrLoop row={row} />
      </td>
      {columns === null ? (
        <StateCells
          row={row}
          selected={selected}
          playing={playing}
          onSelect={onSelect}
          onPlay={onPlay}
          onClarify={onClarify}
        />
      ) : (
        <>
          {people !== null &&
            TASKS.map(({ task, fact }) => (
              <td key={task} className="mid">
                {people.get(cue[fact] ?? '') ?? ''}
              </td>
            ))}
          {columns.map((column) => (
            <td key={column.id} className={column.kind === 'number' ? 'num' : undefined} data-own>
              <ValueCell cue={cue} column={column} projectId={projectId} mayEdit={mayPick} />
            </td>
          ))}
          <td className="mid" title={cue.description}>
            {cue.description}
          </td>
        </>
      )}
    </tr>
  )
})

type StateCellsProps = Pick<LineProps, 'row' | 'selected' | 'playing' | 'onSelect' | 'onPlay' | 'onClarify'>

function StateCells({ row, selected, playing, onSelect, onPlay, onClarify }: StateCellsProps) {
  const { cue, stands } = row
  const remark = (
    <>
      {stands.before}
      {stands.marked && <span className={`tone-${stands.tone} toned`}>{stands.marked}</span>}
      {stands.after}
    </>
  )
  return (
    <>
      <td data-place="wave">
        {row.previewUrl && row.status !== 'cut' ? (
          <button
            type="button"
            className={`block min-h-24px pointer w-full border-0 bg-none ${classes.play}`}
            aria-label={`${playing ? 'Pause' : 'Play'} ${cue.name}`}
            onClick={(event) => {
              event.stopPropagation()
              onSelect(row.id)
              onPlay(row)
            }}
          >
            <WaveThumb peaks={row.peaks} highlighted={selected || playing} />
          </button>
        ) : (
          row.status !== 'cut' && <WaveThumb peaks={row.peaks} />
        )}
      </td>
      <td data-place="state">
        <StatusBadge kind={row.kind}>{row.stateWords}</StatusBadge>
      </td>
      <td className="mid" data-place="stands" title={`${stands.before}${stands.marked}${stands.after}`}>
        {onClarify && row.unclear.length > 0 ? (
          <button
            type="button"
            className={`nowrap pointer overflow-hidden relative p-0 border-0 bg-none text-ellipsis ${classes.remark}`}
            aria-label={`Answer what is unclear about ${cue.name}`}
            onClick={(event) => {
              event.stopPropagation()
              onSelect(row.id)
              onClarify(row.id)
            }}
          >
            {remark}
          </button>
        ) : (
          remark
        )}
      </td>
    </>
  )
}

function SetOrLoop({ row }: { row: CueRow }) {
  const { cue, progress } = row
  if (row.status === 'cut') return null
  if (cue.variations > MANY_VARIATIONS) {
    const here = blocksOf(row).filter(({ tone }) => tone !== 'idle').length
    return <SetBlocks blocks={[]} words={`${here} of ${cue.variations}`} />
  }
  if (cue.variations > 1) return <SetBlocks blocks={blocksOf(row)} />
  if (cue.loop) {
    return (
      <>
        <Icon name="loop" /> loop
      </>
    )
  }
  if (progress && progress.alternates > 1) return `${progress.alternates} alternates`
  if (progress && progress.versions > 1) return `version ${progress.versions}`
  return null
}
