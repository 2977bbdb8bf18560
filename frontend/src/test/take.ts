import type { Fix } from '@/fixing'

import { aFinding, aMe, aPreview, aServer, PROJECT, somePeaks } from './review'

const AT = '2026-11-20T10:00:00Z'
export const DESIGNER = { id: 'designer', name: 'Sound designer' }
const SHAPE = { frames: 4, sample_rate_hz: 48_000, min: [-1, -0.5], max: [1, 0.5], rms: [0.4, 0.2] }

const LOUD = aFinding({
  check: 'sample-peak',
  code: 'sample-peak:over',
  severity: 'error',
  message: 'sample peak 0.00 dBFS, limit -0.1 dBFS',
  fix: 'lower the level by 0.10 dB or more',
  measured: 0,
  limit: -0.1,
  unit: 'dBFS',
  start_s: 0.418,
  end_s: 0.418,
  auto_fix: 'lowers the level by 0.10 dB',
})
export const LATE = aFinding({
  check: 'head-silence',
  code: 'head-silence:over',
  message: '412.0 ms of silence before the sound, limit 5 ms',
  fix: 'trim 407.0 ms or more from the start',
  start_s: 0,
  end_s: 0.412,
  auto_fix: 'trims 407.0 ms from the start',
})

/** A version as it is delivered, for a cue. */
export const aVersion = (take: object = {}) => ({
  id: 't1',
  project_id: PROJECT,
  delivery_id: 'd1',
  designer: DESIGNER,
  cue: { id: 'c1', label: 'SW-009', name: 'airlock_cycle' },
  variation: 1,
  number: 1,
  alternate: null,
  label: null,
  verdict_reasons: [],
  state: 'returned',
  late: false,
  file_name: 'airlock_cycle.wav',
  note: '',
  fix_of_id: null,
  master_sha256: 'a',
  master_bytes: 347_000,
  received_at: AT,
  state_since: AT,
  discarded_at: null,
  sure: null,
  guesses: [],
  already_here: false,
  ...take,
})

export const aCheck = (check: object = {}) => ({
  take_id: 't1',
  state: 'returned',
  verdict: 'rejected',
  spec_version: 1,
  is_newest_spec: true,
  tool_version: '0.1.0',
  created_at: AT,
  facts: { container: 'wav', encoding: 'pcm', sample_rate_hz: 48_000, bit_depth: 24, channels: 1, duration_s: 0.8 },
  measurements: { sample_peak_dbfs: 0, true_peak_dbtp: 0.62, bandwidth_hz: 19_000, head_silence_ms: 412 },
  judgements: {},
  dry_stem: null,
  is_newest_stem: true,
  findings: [LATE, LOUD],
  waiver: null,
  ...check,
})

export const aFix = (fix: Partial<Fix> = {}): Fix => ({
  take_id: 't1',
  state: 'made',
  says: '407.0 ms trimmed from the start, level lowered by 1.62 dB.',
  repairs: [
    { kind: 'head', codes: ['head-silence:over'], words: '407.0 ms trimmed from the start', start_s: 0, end_s: 0.407 },
    { kind: 'gain', codes: ['sample-peak:over'], words: 'level lowered by 1.62 dB', start_s: 0.418, end_s: 0.418 },
  ],
  left: [],
  is_our_fault: false,
  before: { sample_peak_dbfs: 0, true_peak_dbtp: 0.62 },
  after: { sample_peak_dbfs: -1.62, true_peak_dbtp: -1 },
  cut_head_s: 0.4,
  cut_tail_s: 0,
  duration_s: 0.4,
  file_name: 'airlock_cycle.wav',
  spots: [
    { kind: 'head', start_s: 0, end_s: 0.5, after_start_s: 0.4, after_end_s: 0.5, before: SHAPE, after: SHAPE },
    {
      kind: 'gain',
      start_s: 0.403,
      end_s: 0.433,
      after_start_s: 0.403,
      after_end_s: 0.433,
      before: SHAPE,
      after: SHAPE,
    },
  ],
  becomes: 2,
  new_take_id: null,
  used_by: null,
  used_at: null,
  fixed_from: null,
  ...fix,
})

const sound = (id: string, durationS: number) => ({
  picture_id: id,
  duration_s: durationS,
  thumb: null,
  preview_url: `/v1/sounds/${id}/preview`,
  peaks_url: `/v1/sounds/${id}/peaks.json`,
  spectrum_url: null,
})
export const someSounds = (more: object = {}) => ({
  take_id: 't1',
  master: {
    ...sound('s1', 0.8),
    state: 'drawn',
    facts: { sample_rate_hz: 48_000, bit_depth: 24 },
    file_bytes: 347_000,
  },
  fix: sound('m1', 0.4),
  renders: [],
  closed: null,
  ...more,
})
/** The source bank of a version, as its designer sees it. */
export const aSourceBank = (bank: object = {}) => ({
  take_id: 't1',
  is_shown: true,
  is_handed_over: false,
  plug_ins: [],
  recipe: '',
  files: [],
  ...bank,
})
const BANDS = { hz: [100, 1_000, 10_000], dbfs: [-30.1, -12.4, null] }

/** A server with one version that came back, seen by its designer; every answer can be overridden. */
export function aTakeServer() {
  const server = aServer()
    .on('GET /v1/me', asDesigner())
    .on('GET /v1/takes/t1', aVersion())
    .on('GET /v1/takes/t1/check', aCheck())
    .on('GET /v1/takes/t1/sounds', someSounds())
    .on('GET /v1/takes/t1/fix', aFix())
    .on('GET /v1/takes/t1/history', [])
    .on('GET /v1/takes/t1/source-bank', aSourceBank())
  for (const [id, durationS] of [
    ['s1', 0.8],
    ['m1', 0.4],
    ['g1', 0.8],
  ] as const) {
    server
      .on(`GET /v1/sounds/${id}/preview`, { ...aPreview, durationS })
      .on(`GET /v1/sounds/${id}/peaks.json`, { ...somePeaks, bands: BANDS })
  }
  return server
}

const asDesigner = () => ({
  ...aMe({ part: 'designer', is_liaison: false, is_approver: false, engagement_kind: 'contract' }),
  person: DESIGNER,
  studios: [],
})

/** A file for a target that was made of the version. */
export const aGameFile = (file: object = {}) => ({
  ...sound('g1', 0.8),
  id: 'r1',
  target: 'game',
  state: 'made',
  refusal: null,
  facts: { sample_rate_hz: 44_100, bit_depth: 16, channels: 1 },
  measurements: {},
  attenuation_db: 0,
  file_bytes: 70_000,
  file_url: '/v1/renders/r1/file',
  ...file,
})
