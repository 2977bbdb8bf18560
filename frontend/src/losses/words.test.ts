import { expect, test } from 'vitest'

import type { Loss } from './api'
import { linesOf, octavesOf } from './words'

const LOSS: Loss = {
  before: { sample_peak_dbfs: -3, true_peak_dbtp: -2.9, short_loudness_lufs: -14, integrated_lufs: null },
  after: { sample_peak_dbfs: -4, true_peak_dbtp: -3.5, short_loudness_lufs: -15.2, integrated_lufs: null },
  above_nyquist_db: -21.34,
  shelf_db: 0,
  attenuation_db: 1.25,
  requantisation_dbfs: -96.3,
  trimmed_s: [0, 0.25],
  loop_fit_frames: 0,
  seam_before: null,
  seam_after: null,
  mono_loss_db: null,
  spectra: { hz: [500, 1000, 1050, 16_000], master_dbfs: [-20, -31, -30, -50], render_dbfs: [-20, null, -31, null] },
}

test('figures stand beside each other, and only what happened is told', () => {
  const lines = linesOf(LOSS)
  expect(lines).toContainEqual({ what: 'Sample peak', master: '−3.0 dBFS', file: '−4.0 dBFS' })
  expect(lines).toContainEqual({ what: 'Loudness, short sound', master: '−14.0 LUFS', file: '−15.2 LUFS' })
  expect(lines).toContainEqual({ what: 'Energy above the new highest frequency', file: '−21.3 dB' })
  expect(lines).toContainEqual({ what: 'Trimmed at start and end', file: '0.000 and 0.250 s' })
  expect(lines.map(({ what }) => what)).not.toContain('Mono fold-down loss')
  expect(lines.map(({ what }) => what)).not.toContain('Loop adjusted by')
})

test('nothing is said as nothing, never as a number', () => {
  const exact = linesOf({ ...LOSS, above_nyquist_db: null, requantisation_dbfs: null })
  expect(exact.find(({ what }) => what.startsWith('Energy'))?.file).toBe('none')
  expect(exact.find(({ what }) => what.startsWith('Rounding'))?.file).toBe('none')
})

test('an octave is as loud as its loudest band; what the file lost there is nothing', () => {
  expect(octavesOf(LOSS.spectra)).toEqual([
    { what: '500 Hz', master: '−20.0 dBFS', file: '−20.0 dBFS' },
    { what: '1 kHz', master: '−30.0 dBFS', file: '−31.0 dBFS' },
    { what: '16 kHz', master: '−50.0 dBFS', file: 'nothing' },
  ])
})
