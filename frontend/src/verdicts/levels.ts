import { figure } from '@/ui/format'

/** What the server measured of a sound; null where it did not. */
export interface Level {
  loudnessLufs: number | null
  truePeakDbtp: number | null
}

/** No gain lifts a true peak over this. */
const PEAK_LIMIT_DBTP = -1
/** Lifting by more than this brings up noise: the others come down instead. */
const MAX_LIFT_DB = 24

/**
 * The gains that bring sounds to one loudness, in dB; 0 for a sound that was not measured.
 *
 * The first measured sound stays as it is, as long as none of the others would have to pass the limit for that.
 * Otherwise all come down together, so that the differences stay those of the loudness. A sound whose true peak is
 * not known is never lifted.
 */
export function matchedGainsDb(levels: readonly Level[]): number[] {
  const measured = levels.flatMap(({ loudnessLufs }) => loudnessLufs ?? [])
  const [targetLufs] = measured
  if (targetLufs === undefined || measured.length < 2) return levels.map(() => 0)
  let downDb = 0
  for (const { loudnessLufs, truePeakDbtp } of levels) {
    if (loudnessLufs === null) continue
    const liftDb = targetLufs - loudnessLufs
    downDb = Math.max(downDb, liftDb + (truePeakDbtp ?? PEAK_LIMIT_DBTP) - PEAK_LIMIT_DBTP, liftDb - MAX_LIFT_DB)
  }
  return levels.map(({ loudnessLufs }) => (loudnessLufs === null ? 0 : targetLufs - loudnessLufs - downDb))
}

/** How the levels of some sounds were matched, in a few words. */
export function loweredWords(gainsDb: readonly number[]): string {
  const [first = 0] = gainsDb
  return first < -0.05 ? `Levels matched, the first lowered by ${figure(-first, 1)} dB` : 'Levels matched to the first'
}

const MAX_NAMED = 4

/** "matched: A −3.2 dB, B −9.1 dB"; of many sounds the range. */
export function matchedWords(named: readonly { name: string; gainDb: number }[]): string {
  const gains = named.map(({ gainDb }) => gainDb)
  if (named.length < 2) return ''
  const words =
    named.length > MAX_NAMED
      ? `${signed(Math.min(...gains))} to ${signed(Math.max(...gains))}`
      : named.map(({ name, gainDb }) => `${name} ${signed(gainDb)}`).join(', ')
  return `matched: ${words}`
}

function signed(db: number): string {
  const text = figure(db, 1)
  return `${db > 0 && text !== '0.0' ? '+' : ''}${text} dB`
}
