import { figure, level } from '@/ui/format'

import type { Loss } from './api'

export interface LossLine {
  what: string
  master?: string
  file: string
}

/** null in a figure of dB means silence. */
const decibels = (value: number | null, decimals = 1): string =>
  value === null ? 'none' : `${figure(value, decimals)} dB`

/** The figures of a loss as lines of a table: what was measured of both, and what the way between them cost. */
export function linesOf({ before, after, ...loss }: Loss): LossLine[] {
  const lines: LossLine[] = [
    {
      what: 'Sample peak',
      master: level(before.sample_peak_dbfs, 'dBFS'),
      file: level(after.sample_peak_dbfs, 'dBFS'),
    },
    { what: 'True peak', master: level(before.true_peak_dbtp, 'dBTP'), file: level(after.true_peak_dbtp, 'dBTP') },
    loudnessLine(before, after),
    { what: 'Energy above the new highest frequency', file: decibels(loss.above_nyquist_db) },
    { what: 'Lowered to stay under the peak limit', file: decibels(loss.attenuation_db, 2) },
    {
      what: 'Rounding, dither or codec noise',
      file: loss.requantisation_dbfs === null ? 'none' : `${figure(loss.requantisation_dbfs, 1)} dBFS`,
    },
  ]
  if (loss.shelf_db > 0) lines.push({ what: 'Top octave boosted', file: decibels(loss.shelf_db) })
  if (loss.mono_loss_db !== null) lines.push({ what: 'Mono fold-down loss', file: decibels(loss.mono_loss_db) })
  const [head = 0, tail = 0] = loss.trimmed_s
  if (head > 0 || tail > 0)
    lines.push({ what: 'Trimmed at start and end', file: `${figure(head, 3)} and ${figure(tail, 3)} s` })
  if (loss.loop_fit_frames !== 0) {
    lines.push({ what: 'Loop adjusted by', file: `${figure(loss.loop_fit_frames, 2)} frames` })
  }
  if (loss.seam_before && loss.seam_after) {
    lines.push({
      what: 'Step at the loop point',
      master: decibels(loss.seam_before.step_db),
      file: decibels(loss.seam_after.step_db),
    })
  }
  return lines
}

/** Short sounds have no integrated loudness; both are then described by the loudest moment. */
function loudnessLine(before: Loss['before'], after: Loss['after']): LossLine {
  const whole = before.integrated_lufs !== null && after.integrated_lufs !== null
  const of = (levels: Loss['before']) => level(whole ? levels.integrated_lufs : levels.short_loudness_lufs, 'LUFS')
  return { what: whole ? 'Loudness' : 'Loudness, short sound', master: of(before), file: of(after) }
}

/** The spectra in octaves, which is enough detail for a table: the loudest band of each. */
export function octavesOf({ hz, master_dbfs, render_dbfs }: Loss['spectra']): LossLine[] {
  const octaves = new Map<number, { master: number | null; file: number | null }>()
  hz.forEach((band, at) => {
    const middle = 1000 * 2 ** Math.round(Math.log2(band / 1000))
    const before = octaves.get(middle) ?? { master: null, file: null }
    octaves.set(middle, {
      master: louder(before.master, master_dbfs[at] ?? null),
      file: louder(before.file, render_dbfs[at] ?? null),
    })
  })
  return [...octaves].map(([middle, { master, file }]) => ({
    what: middle >= 1000 ? `${figure(middle / 1000)} kHz` : `${figure(middle, middle < 100 ? 1 : 0)} Hz`,
    master: master === null ? 'nothing' : `${figure(master, 1)} dBFS`,
    file: file === null ? 'nothing' : `${figure(file, 1)} dBFS`,
  }))
}

function louder(a: number | null, b: number | null): number | null {
  if (a === null) return b
  return b === null ? a : Math.max(a, b)
}
