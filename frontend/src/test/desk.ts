import { type Answers } from './server'

export const CUE = { id: 'c9', label: 'SW-009', name: 'airlock_cycle' }
export const WARP = { id: 'c18', label: 'SW-018', name: 'warp_in' }
export const STING = { id: 'c13', label: 'SW-013', name: 'victory_sting' }

export const FINDINGS = [
  {
    check: 'head-silence',
    code: 'head-silence:over',
    severity: 'warning',
    message: '412.0 ms of silence before the sound, limit 5 ms',
    fix: 'trim 407.0 ms or more from the start',
    measured: 412,
    limit: 5,
    unit: 'ms',
    start_s: 0,
    end_s: 0.412,
  },
  {
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
  },
]
export const RETURNED = {
  take_id: 't9',
  cue: CUE,
  number: 1,
  variation: 1,
  file_name: 'airlock_cycle.wav',
  status: 'returned',
  since: '2026-11-17T09:00:00Z',
  duration_s: 2.412,
  thumb: null,
  preview_url: '/v1/sounds/s9/preview',
  peaks_url: '/v1/sounds/s9/peaks.json',
  findings: FINDINGS,
  changes: [],
  comments: [],
  round: null,
  limit_dbfs: -0.1,
}
export const CHANGED = {
  ...RETURNED,
  take_id: 't19',
  cue: { id: 'c19', label: 'SW-019', name: 'missile_launch' },
  number: 2,
  file_name: 'missile_launch.wav',
  status: 'change_requested',
  findings: [],
  changes: [{ id: 'change-1', text: 'Thrust comes too late', start_s: 0.5, end_s: null }],
  round: 1,
}
export const toMake = (cue: typeof CUE, more: object = {}) => ({
  cue,
  use: 'Own ship arrives',
  category: 'vehicle',
  duration_s: 1.4,
  duration_min_s: null,
  duration_max_s: null,
  loop: false,
  variations: 1,
  missing: 1,
  state: 'locked',
  status: 'to_make',
  ...more,
})
export const DESK = {
  came_back: [RETURNED, CHANGED],
  to_make: [
    toMake(WARP),
    toMake({ id: 'c3', label: 'SW-003', name: 'laser_fire' }, { variations: 4, missing: 2 }),
    toMake({ id: 'c21', label: 'SW-021', name: 'void_whale' }, { state: 'concept' }),
  ],
  with_approver: [
    { id: 'c7', label: 'SW-007', name: 'shield_hit', accepted_after: '2030-03-15', silence_paused_by: null },
  ],
  came_back_next: null,
  came_back_cues: 2,
  to_make_next: null,
  to_make_cues: 3,
  with_approver_next: null,
  with_approver_cues: 1,
  with_approver_files: 3,
  accepted: 6,
  cues: 23,
  unmatched: 1,
  checking: 0,
  questions: [
    {
      id: 'q1',
      cue: { id: 'c10', label: 'SW-010', name: 'coolant_splash' },
      text: 'What falls in?',
      asked_by: { id: 'x3', name: 'Sound designer' },
      asked_at: '2026-11-12T09:00:00Z',
      answer: 'A tool.',
      answered_at: '2026-11-13T09:00:00Z',
      owner: null,
      due_on: null,
      blocks: false,
    },
  ],
}
export const aGuess = (
  { id, label, name }: typeof CUE,
  reason: string,
  variation: number | null = 1,
  variations = 1,
) => ({
  cue_id: id,
  label,
  name,
  variation,
  variations,
  reason,
  becomes: variation === null ? null : `${name}.wav`,
})
export const UNMATCHED = {
  id: 't30',
  project_id: 'p1',
  delivery_id: 'd3',
  designer: { id: 'x3', name: 'Sound designer' },
  cue: null,
  variation: 1,
  number: null,
  alternate: null,
  label: null,
  verdict_reasons: [],
  state: 'returned',
  late: false,
  file_name: 'final_FINAL_sting2.wav',
  note: '',
  master_sha256: 'a',
  master_bytes: 1000,
  received_at: '2026-11-17T09:00:00Z',
  state_since: '2026-11-17T09:00:00Z',
  guesses: [aGuess(STING, 'the name has "sting"'), aGuess(WARP, 'the name is spelt nearly alike')],
  already_here: false,
  discarded_at: null,
  sure: null,
}
const SOUNDS = {
  take_id: 't30',
  master: {
    picture_id: 's30',
    duration_s: 3.02,
    thumb: null,
    preview_url: '/v1/sounds/s30/preview',
    peaks_url: null,
    spectrum_url: null,
    state: 'drawn',
    facts: { channels: 2, sample_rate_hz: 96_000 },
    file_bytes: 1000,
  },
  renders: [],
  closed: null,
}
export const DELIVERY = {
  id: 'd4',
  project_id: 'p1',
  number: 4,
  note: '',
  created_at: '2026-11-17T09:00:00Z',
  closed_at: null,
  designer: { id: 'x3', name: 'Sound designer' },
  takes_count: 0,
}
export const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  studios: [],
  projects: [
    {
      id: 'p1',
      name: 'Shield Wing',
      studio_id: 's1',
      studio_name: 'Shield Wing studio',
      cue_prefix: 'SW',
      part: 'designer',
      is_producer: false,
      is_liaison: false,
      is_approver: false,
      engagement_kind: 'contract',
    },
  ],
}
const cue = ({ id, label, name }: typeof CUE) => ({ id, label, name, use: '', stems: [name], cut_at: null })

let personNumber = 0
/** The answers of a project's desk. Uploads outlive a page for one person, so every test has another person. */
export const atDesk = (more: Answers = {}): Answers => {
  const person = { id: `x${personNumber++}`, name: 'Sound designer' }
  return {
    'GET /v1/session': { signed_in: true, demo: false, person },
    'GET /v1/me': { ...ME, person },
    'GET /v1/projects/p1/desk': DESK,
    'GET /v1/projects/p1/takes/undecided': [],
    'GET /v1/projects/p1/spec': { tables: { accept: { containers: ['wav'] } } },
    'GET /v1/projects/p1/deliveries': { items: [], next: null },
    'GET /v1/projects/p1/takes': { items: [UNMATCHED], next: null },
    'GET /v1/projects/p1/sound-list': { revision: 7, cues: [CUE, WARP, STING].map(cue) },
    'GET /v1/takes/t30/sounds': SOUNDS,
    ...more,
  }
}
