import { useQuery } from '@tanstack/react-query'

import type { ReviewTake } from '@/verdicts/api'
import { level } from '@/ui/format'

import { paletteQuery } from './api'
import classes from './Side.module.css'

interface PalettePlotProps {
  projectId: string
  takes: readonly ReviewTake[]
  hand: ReviewTake
  nameOf: (take: ReviewTake) => string
}

interface Point {
  name: string
  lufs: number
}

const NAMES_APART = 0.24
const LETTERS_APART = 0.09
const STOREY_PX = 20

/** The loudness of the versions and of the palette's sounds, on one line. */
export function PalettePlot({ projectId, takes, hand, nameOf }: PalettePlotProps) {
  const { data: sounds = [] } = useQuery(paletteQuery(projectId))
  const palette = sounds.flatMap(({ cue, loudness_lufs }): Point[] =>
    loudness_lufs === null ? [] : [{ name: cue.name, lufs: loudness_lufs }],
  )
  const own = takes.flatMap((take) =>
    take.loudness_lufs === null
      ? []
      : [{ id: take.id, name: takes.length > 1 ? nameOf(take) : '', lufs: take.loudness_lufs }],
  )
  if (palette.length === 0 || own.length === 0) return null
  const all = [...palette, ...own].map(({ lufs }) => lufs)
  const from = Math.min(...all) - 2
  const to = Math.max(...all) + 2
  const share = (lufs: number) => (lufs - from) / (to - from)
  const storeys = stacked(own, share)
  const words = [...own, ...palette]
    .map(({ name, lufs }) => `${name || 'this version'} ${level(lufs, 'LUFS')}`)
    .join('; ')
  return (
    <section className={classes.block} aria-label="Compared with the palette">
      <p className="row between small">
        <span className="strong">Compared with the palette</span>
        <span className="dim">LUFS</span>
      </p>
      <div
        className={`relative ${classes.plot}`}
        style={{ height: 26 + STOREY_PX * Math.max(...storeys.map(({ storey }) => storey), 1) }}
        role="img"
        aria-label={words}
      >
        {palette.map(({ name, lufs }) => (
          <i key={name} style={{ left: `${share(lufs) * 100}%` }} />
        ))}
        {named(palette, share).map(({ name, lufs }) => (
          <span key={name} style={{ left: `${share(lufs) * 100}%` }}>
            {name}
          </span>
        ))}
        {storeys.map(({ id, name, lufs, storey }) => (
          <b
            key={id}
            data-on={id === hand.id || undefined}
            style={{ left: `${share(lufs) * 100}%`, bottom: 9 + storey * STOREY_PX }}
          >
            {name.replace('_0', '').replace('_', '')}
          </b>
        ))}
      </div>
    </section>
  )
}

interface Own extends Point {
  id: string
}

/** Each one above those that it would cover. */
function stacked(own: readonly Own[], share: (lufs: number) => number): (Own & { storey: number })[] {
  const placed: (Own & { storey: number })[] = []
  for (const sound of own.toSorted((a, b) => a.lufs - b.lufs)) {
    const near = placed.filter((other) => share(sound.lufs) - share(other.lufs) < LETTERS_APART)
    const taken = new Set(near.map((other) => other.storey))
    let storey = 0
    while (taken.has(storey)) storey += 1
    placed.push({ ...sound, storey })
  }
  return placed
}

/** Those whose names find room below the line. */
function named(palette: readonly Point[], share: (lufs: number) => number): Point[] {
  const shown: Point[] = []
  for (const point of palette.toSorted((a, b) => a.lufs - b.lufs)) {
    const last = shown.at(-1)
    if (last === undefined || share(point.lufs) - share(last.lufs) >= NAMES_APART) shown.push(point)
  }
  return shown
}
