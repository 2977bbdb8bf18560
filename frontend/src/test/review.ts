import type { Me } from '@/api/me'
import type {
  CarriedNote,
  ChangeRequest,
  CueReview,
  QueueItem,
  ReviewCue,
  ReviewFinding,
  ReviewTake,
} from '@/verdicts/api'

import type { ReviewReasons } from '@/verdicts/reasons'

import { type Asked, serve } from './server'

export const PROJECT = 'project-1'
/** The lists of a studio that wrote none. */
export const OURS: ReviewReasons = {
  change: {
    is_own: false,
    reasons: [
      'Too loud',
      'Too quiet',
      'Too long',
      'Too short',
      'Starts too late',
      'Too bright',
      'Too dull',
      'Doesn’t read in game',
      'Off style',
    ],
  },
  pick: {
    is_own: false,
    reasons: ['Fits the scene', 'Best timing', 'Best weight', 'Cleanest', 'Most readable', 'Most like the palette'],
  },
  label: { is_own: false, reasons: ['longer', 'shorter', 'layered', 'dry', 'wild', 'safe'] },
}
const AT = '2026-11-20T10:00:00Z'
const DESIGNER = { id: 'designer', name: 'Sound designer' }
export const APPROVER = { id: 'approver', name: 'Audio director' }
const THUMB = { points: 2, min: [-90, -20], max: [90, 20], rms: [40, 8] }

export function aFinding(finding: Partial<ReviewFinding> = {}): ReviewFinding {
  return {
    check: 'true-peak',
    code: 'true-peak:over',
    severity: 'warning',
    message: 'true peak -0.60 dBTP, limit -1 dBTP',
    fix: 'lower the level by 0.40 dB or more',
    measured: -0.6,
    limit: -1,
    unit: 'dBTP',
    start_s: 0.01,
    end_s: 0.01,
    waived: false,
    ...finding,
  }
}

export function aTake(id: string, take: Partial<ReviewTake> = {}): ReviewTake {
  return {
    id,
    picture_id: id,
    duration_s: 0.8,
    thumb: THUMB,
    preview_url: `/v1/sounds/${id}/preview`,
    peaks_url: `/v1/sounds/${id}/peaks.json`,
    spectrum_url: null,
    variation: 1,
    number: 1,
    alternate: null,
    label: null,
    file_name: `${id}.wav`,
    state: 'conforming',
    state_since: AT,
    received_at: AT,
    late: false,
    note: '',
    delivery_number: 13,
    delivery_note: '',
    designer: DESIGNER,
    facts: { sample_rate_hz: 48_000, bit_depth: 24, channels: 1, duration_s: 0.8 },
    loudness_lufs: -16,
    away_from_set_lu: null,
    sample_peak_dbfs: -1.2,
    true_peak_dbtp: -1,
    measurements: {},
    findings: [],
    waived: false,
    waiver_reason: null,
    fix_of_id: null,
    renders: [],
    draft_change: null,
    open_comments: 0,
    heard_at: null,
    is_heard: true,
    undecided_with: [],
    ...take,
  }
}

export function aCue(cue: Partial<ReviewCue> = {}): ReviewCue {
  return {
    id: 'cue-1',
    project_id: PROJECT,
    label: 'SW-007',
    name: 'shield_hit',
    description: 'An enemy shot meets the shield.',
    use: '',
    category: 'weapon',
    duration_s: 0.8,
    loop: false,
    variations: 1,
    state: 'locked',
    reverb: 'dry',
    channels: null,
    placeholder: false,
    palette: false,
    due_on: null,
    ...cue,
  }
}

export function anItem(cue: Partial<ReviewCue>, takes: ReviewTake[], item: Partial<QueueItem> = {}): QueueItem {
  const findings = takes.flatMap((take) => take.findings)
  const whole = aCue(cue)
  return {
    cue: whole,
    kind: whole.variations > 1 ? 'set' : takes.length > 1 ? 'alternates' : 'single',
    waiting_since: AT,
    is_urgent: false,
    rounds_so_far: 0,
    last_change: null,
    open_notes: 0,
    approved_variations: [],
    accepted_after: null,
    silence_paused_by: null,
    findings_count: findings.length,
    worst_finding: findings[0] ?? null,
    takes,
    blocked: [],
    ...item,
  }
}

export function aReview(item: QueueItem, review: Partial<CueReview> = {}): CueReview {
  return {
    cue: item.cue,
    kind: item.kind,
    accepted: false,
    approved_variations: item.approved_variations,
    accepted_after: item.accepted_after,
    silence_paused_by: item.silence_paused_by,
    approver: APPROVER,
    deputies: [],
    on_behalf_of: null,
    may_approve: true,
    takes: item.takes.toReversed(),
    comments: [],
    verdicts: [],
    change_requests: [],
    carried_notes: [],
    checklist: { blockers: 'none', items: [], checks: [], blocked: [] },
    rounds: [],
    ...review,
  }
}

export function aDraft(take: ReviewTake, cue: ReviewCue, text: string): ChangeRequest {
  return {
    id: `draft-${take.id}`,
    take_id: take.id,
    cue_id: cue.id,
    cue_label: cue.label,
    cue_name: cue.name,
    variation: take.variation,
    number: take.number,
    text,
    reasons: [],
    mentions: [],
    start_s: null,
    end_s: null,
    reverses: false,
    written_by: APPROVER,
    created_at: AT,
    feedback_id: null,
    sends_at: null,
    sent_at: null,
  }
}

export function aNote(id: string, text: string, note: Partial<CarriedNote> = {}): CarriedNote {
  return {
    id,
    kind: 'comment',
    take_id: 'old',
    variation: 1,
    number: 1,
    text,
    start_s: null,
    end_s: null,
    author: APPROVER,
    decides: true,
    created_at: AT,
    answer: null,
    ...note,
  }
}

export function aMe(project: Partial<Me['projects'][number]> = {}): Me {
  return {
    person: APPROVER,
    email: 'approver@studio.example',
    email_verified_at: null,
    is_operator: false,
    has_contracts: true,
    studios: [{ id: 'studio-1', name: 'Studio', roles: ['liaison'] }],
    projects: [
      {
        id: PROJECT,
        name: 'Shield Wing',
        studio_id: 'studio-1',
        studio_name: 'Studio',
        cue_prefix: 'SW',
        part: 'team',
        is_producer: false,
        is_liaison: true,
        is_approver: true,
        approves_all: true,
        engagement_kind: null,
        nda_open: false,
        is_sample: false,
        ...project,
      },
    ],
  }
}

/** What the server sends for a preview and for peaks, as the hand-turned context decodes it. */
export const aPreview = { durationS: 0.8 }
export const somePeaks = {
  points: 2,
  frames: 4,
  sample_rate_hz: 48_000,
  duration_s: 0.8,
  min: [-0.5, -0.1],
  max: [0.5, 0.1],
  rms: [0.2, 0],
}

/** A server with queued answers, which records the requests to one path. */
export function aServer() {
  const { asked, answers } = serve({
    'GET /v1/session': { signed_in: true, demo: false, person: APPROVER },
    [`GET /v1/projects/${PROJECT}/review-reasons`]: OURS,
  })
  const server = {
    asked,
    on: (what: string, answer: unknown) => {
      answers[what] = answer
      return server
    },
    of: (what: string): Asked[] => asked.filter(({ method, path }) => `${method} ${path}` === what),
  }
  return server
}
