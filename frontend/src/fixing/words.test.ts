import { describe, expect, test } from 'vitest'

import type { Fix } from './api'
import { movedFigures, spotName, describeNextStep } from './words'

const fix = (more: Partial<Fix> = {}): Fix => ({
  take_id: 't1',
  state: 'made',
  says: '',
  repairs: [],
  left: [],
  is_our_fault: false,
  before: { sample_peak_dbfs: 0, true_peak_dbtp: 0.62, integrated_lufs: -11.4, bandwidth_hz: 20_000 },
  after: { sample_peak_dbfs: -1.62, true_peak_dbtp: -1, integrated_lufs: -13.02, bandwidth_hz: 20_000 },
  cut_head_s: 0,
  cut_tail_s: 0,
  duration_s: 2,
  file_name: 'a.wav',
  spots: [],
  becomes: 3,
  new_take_id: null,
  used_by: null,
  used_at: null,
  fixed_from: null,
  ...more,
})

describe('what a fix moves', () => {
  test('is told in levels with units, before and after', () => {
    expect(movedFigures(fix())).toEqual([
      { what: 'Sample peak', before: '0.0 dBFS', after: '−1.6 dBFS' },
      { what: 'True peak', before: '0.6 dBTP', after: '−1.0 dBTP' },
      { what: 'Loudness', before: '−11.4 LUFS', after: '−13.0 LUFS' },
    ])
  })

  test('a tenth that would hide the move gives way to a hundredth', () => {
    const seen = fix({ before: { true_peak_dbtp: -0.96 }, after: { true_peak_dbtp: -1.04 } })
    expect(movedFigures(seen)).toEqual([{ what: 'True peak', before: '−0.96 dBTP', after: '−1.04 dBTP' }])
  })

  test('an offset is given in per cent', () => {
    const centred = fix({ before: { dc_offset_percent: 5.003 }, after: { dc_offset_percent: 0.0001 } })
    expect(movedFigures(centred)).toEqual([{ what: 'DC offset', before: '5.0 %', after: '0.0 %' }])
  })

  test('what stays is left out, and a cut tells the length', () => {
    const cut = fix({ after: { sample_peak_dbfs: 0 }, cut_head_s: 0.4, cut_tail_s: 0.1, duration_s: 2 })
    expect(movedFigures(cut)).toEqual([{ what: 'Length', before: '2.50 s', after: '2.00 s' }])
  })
})

test('a spot is named by what is done there', () => {
  const shape = { frames: 0, sample_rate_hz: 48_000, min: [], max: [], rms: [] }
  const spot = { start_s: 0, end_s: 0.437, after_start_s: 0, after_end_s: 0.437, before: shape, after: shape }
  expect(spotName({ kind: 'head', ...spot })).toBe('The start, 0.000–0.437 s')
  expect(spotName({ kind: 'gain', ...spot })).toBe('The loudest part, 0.000–0.437 s')
  expect(spotName({ kind: 'offset', ...spot })).toBe('The start, 0.000–0.437 s')
})

test('what follows names both versions, and that no round counts', () => {
  expect(describeNextStep(fix(), 2)).toBe('It becomes version 3; version 2 is kept. No round is counted.')
  expect(describeNextStep(fix({ becomes: null }), null)).toBe(
    'It becomes a new version; your master is kept. No round is counted.',
  )
})
