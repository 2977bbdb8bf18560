import { figure, level } from '@/ui/format'
import { Table } from '@/ui/Table'

import type { MaskedBand, Masking } from './api'
import classes from './Scene.module.css'

const RANGE_DB = 60
const MARKS_HZ = [100, 300, 1_000, 3_000, 10_000]

interface MaskingPlotProps {
  masking: Masking
  /** The names of lanes, by id. */
  names: ReadonlyMap<string, string>
  name: string
}

/** Which bands of a version are heard: ink where it stands above what covers it, hatched where it does not. */
export function MaskingPlot({ masking, names, name }: MaskingPlotProps) {
  const { bands } = masking
  const levels = bands.flatMap(({ sound_db, cover_db }) => [sound_db ?? -Infinity, cover_db ?? -Infinity])
  const topDb = Math.ceil(Math.max(-RANGE_DB, ...levels) / 10) * 10
  const share = (db: number | null) => (db === null ? 0 : Math.min(1, Math.max(0, (db - topDb + RANGE_DB) / RANGE_DB)))
  return (
    <figure className="grid gap-1">
      <div className={`flex bg-well overflow-hidden ${classes.bands}`} role="img" aria-label={masking.in_words}>
        {bands.map((band) => (
          <Band key={band.hz} band={band} share={share} />
        ))}
      </div>
      <div className={`relative ${classes.hz}`} aria-hidden="true">
        {MARKS_HZ.map((hz) => (
          <span key={hz} style={{ left: `${placeOf(hz, bands) * 100}%` }}>
            {hz >= 1_000 ? `${hz / 1_000}k` : hz}
          </span>
        ))}
      </div>
      <figcaption className="small mid">{masking.in_words}</figcaption>
      <p className={`small dim flex wrap ${classes.legend}`}>
        <span data-is="heard">{name} heard</span>
        <span data-is="covered">covered</span>
        <span data-is="cover">what covers it</span>
      </p>
      <details className="small">
        <summary>Figures by band</summary>
        <Table
          label="Figures by band"
          rows={bands}
          keyOf={({ hz }) => hz}
          columns={[
            { head: 'Hz', rowHead: true, cell: ({ hz }) => figure(hz) },
            { head: 'Sound', cell: (band) => (band.is_part ? level(band.sound_db) : 'nothing') },
            { head: 'Heard from', cell: ({ cover_db: cover }) => (cover === null ? 'any level' : level(cover)) },
            { head: 'Heard', cell: (band) => (band.is_part ? (band.is_heard ? 'yes' : 'covered') : '') },
            { head: 'Strongest other', cell: ({ covered_by: by }) => (by === null ? '' : names.get(by)) },
          ]}
        />
      </details>
    </figure>
  )
}

function Band({ band, share }: { band: MaskedBand; share: (db: number | null) => number }) {
  const cover = share(band.cover_db)
  const sound = band.is_part ? share(band.sound_db) : 0
  return (
    <span className={`flex-1 relative ${classes.band}`}>
      <i data-is="cover" style={{ height: `${cover * 100}%` }} />
      {band.is_part && !band.is_heard && <i data-is="covered" style={{ height: `${sound * 100}%` }} />}
      {band.is_heard && (
        <i data-is="heard" style={{ bottom: `${cover * 100}%`, height: `${Math.max(0.01, sound - cover) * 100}%` }} />
      )}
    </span>
  )
}

/** Where a frequency lies among the bands, 0 to 1. */
function placeOf(hz: number, bands: readonly MaskedBand[]): number {
  const above = bands.findIndex((band) => band.hz >= hz)
  if (above <= 0) return 0
  const [low, high] = [bands[above - 1]?.hz ?? hz, bands[above]?.hz ?? hz]
  return (above - 0.5 + Math.log(hz / low) / Math.log(high / low)) / bands.length
}
