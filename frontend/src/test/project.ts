import type { components } from '@/api/schema.gen'

import checks from './checks.json'
import type { Answers } from './server'

type Schemas = components['schemas']

const WHO = {
  producer: { id: 'x1', name: 'Producer' },
  approver: { id: 'x2', name: 'Audio director' },
  designer: { id: 'x3', name: 'Sound designer' },
  composer: { id: 'x4', name: 'Composer' },
}
export const people = WHO

export const TOML = `format = 1
name = "Shield Wing"

[limits]
true_peak_dbtp = -1.0               # a warning
head_silence_ms = 5

[targets.game]
sample_rate_hz = 48000
bit_depth = 16

[categories.music]
kind = "music"
accept.duration_s = { max = 300.0 }
`

const NONE = { min: null, max: null }
const RESOLVED = {
  name: 'Shield Wing',
  accept: {
    containers: ['wav'],
    encodings: ['pcm'],
    sample_rates_hz: [48000, 96000],
    bit_depths: [24],
    channels: [1, 2],
    layouts: null,
    duration_s: { min: 0.01, max: 30 },
  },
  limits: {
    sample_peak_dbfs: -0.1,
    true_peak_dbtp: -1,
    dc_offset_percent: null,
    silence_below_dbfs: null,
    head_silence_ms: 5,
    tail_silence_ms: null,
    edge_silence_below_dbfs: -60,
    tolerance_db: 0.05,
    loudness_lufs: NONE,
    noise_floor_dbfs: null,
    mono_loss_db: null,
    others: {},
  },
  naming: { pattern: null, extension: '.wav', tokens: [], separator: '_', grammar: null, portable: true },
  required_metadata: [],
  engine: { adds: [] },
  targets: {
    game: {
      name: 'game',
      sample_rate_hz: 48000,
      bit_depth: 16,
      encoding: 'pcm',
      channels: 'master',
      dither: 'tpdf',
      over_peak: 'attenuate',
    },
  },
  checks: { 'true-peak': 'warning' },
  categories: ['music'],
}

export const TABLES = {
  format: 1,
  name: 'Shield Wing',
  limits: { true_peak_dbtp: -1, head_silence_ms: 5 },
  naming: { pattern: '[a-z0-9]+(_[a-z0-9]+)*', extension: '.wav' },
  targets: { game: { sample_rate_hz: 48000, bit_depth: 16 } },
  checks: { 'true-peak': 'warning' },
  categories: { music: { kind: 'music', accept: { duration_s: { max: 300 } } } },
}

export const aSpec = (more: Record<string, unknown> = {}) => ({
  version: 3,
  sha256: 'a'.repeat(64),
  note: 'Handheld dropped',
  created_at: '2026-11-09T10:00:00Z',
  author: WHO.producer,
  toml: TOML,
  tables: TABLES,
  resolved: RESOLVED,
  warnings: [],
  ...more,
})

/** What a try comes to, when it comes to a spec. */
export const tried = (toml: string, tables: unknown = TABLES, warnings: string[] = []) => ({
  toml,
  sha256: 'b'.repeat(64),
  tables,
  resolved: RESOLVED,
  warnings,
})

type Part = 'producer' | 'reviewer' | 'designer'

const PARTS = {
  producer: {
    is_producer: true,
    is_liaison: false,
    is_approver: false,
    engagement_kind: null,
    nda_open: false,
  },
  reviewer: {
    is_producer: false,
    is_liaison: false,
    is_approver: false,
    engagement_kind: null,
    nda_open: false,
  },
  designer: {
    is_producer: false,
    is_liaison: false,
    is_approver: false,
    engagement_kind: 'contract',
    nda_open: false,
  },
}

export const aProject = (part: Part = 'producer', more: Record<string, unknown> = {}) => ({
  id: 'p1',
  name: 'Shield Wing',
  description: 'Space strategy for PC and handheld.',
  cue_prefix: 'SW',
  created_at: '2026-11-01T10:00:00Z',
  archived_at: null,
  designers_hear: 'approved',
  studio: { id: 's1', name: 'Shield Wing studio' },
  approver: WHO.approver,
  category_approvers: [],
  liaisons: [WHO.approver],
  audio_leads_warning: null,
  engagements: [
    { id: 'e1', designer: WHO.designer, kind: 'contract', created_at: '2026-11-02T10:00:00Z', ended_at: null },
  ],
  mine: { is_team: part !== 'designer', ...PARTS[part] },
  spec_version: 3,
  ...more,
})

const step = (number: number, name: string, status: string, palette = false) => ({
  cue: { id: `c${number}`, label: `SW-00${number}`, name },
  palette,
  status,
})

/** How a project goes in which nothing was decided yet. */
export const aPace = (facts: Partial<Schemas['Pace']> = {}): Schemas['Pace'] => ({
  cues: 2,
  accepted: 0,
  first_pass: null,
  first_pass_lately: null,
  first_pass_before: null,
  rounds_per_cue: null,
  days_late: null,
  overdue: 0,
  finish_on: null,
  needed_on: null,
  worn: [],
  studio: {
    review_hours: null,
    waiting_reviews: 0,
    longest_review_wait_hours: null,
    answer_hours: null,
    open_questions: 0,
    longest_answer_wait_hours: null,
    days_to_pay: null,
    late_invoices: 0,
  },
  costs: [],
  estimates: null,
  over_estimate: null,
  ...facts,
})

export const anOverview = (more: Record<string, unknown> = {}) => ({
  // In list order the palette comes second.
  steps: [step(1, 'shield_hit', 'to_review'), step(2, 'ui_confirm', 'accepted', true), step(3, 'mine_arm', 'cut')],
  cues: 3,
  counts: { to_review: 1, accepted: 1, cut: 1 },
  builds: [],
  needs: [],
  palette: [],
  lately: [],
  reviewers: 4,
  ...more,
})

const aCue = (name: string, category: string) => ({
  id: name,
  number: 1,
  label: 'SW-001',
  name,
  category,
  state: 'locked',
  stems: [name],
})

const members = [
  { person: WHO.producer, email: 'producer@studio.example', roles: ['producer'], since: '2026-11-01T10:00:00Z' },
  { person: WHO.approver, email: 'director@studio.example', roles: ['liaison'], since: '2026-11-01T10:00:00Z' },
  { person: WHO.composer, email: 'composer@studio.example', roles: ['reviewer'], since: '2026-11-01T10:00:00Z' },
]

const me = (part: Part) => ({
  person: part === 'designer' ? WHO.designer : part === 'producer' ? WHO.producer : WHO.composer,
  email: `${part}@studio.example`,
  studios: part === 'designer' ? [] : [{ id: 's1', name: 'Shield Wing studio', roles: [part] }],
  projects: [
    {
      id: 'p1',
      name: 'Shield Wing',
      studio_id: 's1',
      studio_name: 'Shield Wing studio',
      cue_prefix: 'SW',
      part: part === 'designer' ? 'designer' : 'team',
      ...PARTS[part],
    },
  ],
})

/** Everything that the pages of a project request, for a person with this role. */
export const inProject = (part: Part = 'producer', more: Answers = {}): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: me(part).person },
  'GET /v1/me': me(part),
  'GET /v1/review-queue/count': { cues: 0, is_all: true },
  'GET /v1/projects/p1': aProject(part),
  'GET /v1/projects/p1/overview': anOverview(),
  'GET /v1/projects/p1/pace': aPace(),
  'GET /v1/projects/p1/handovers': [],
  'GET /v1/projects/p1/playlists': [],
  'GET /v1/projects/p1/review-reasons': Object.fromEntries(
    ['change', 'pick', 'label'].map((kind) => [kind, { is_own: false, reasons: [] }]),
  ),
  'GET /v1/projects/p1/spec': aSpec(),
  'GET /v1/checks': checks,
  'GET /v1/studios/s1/invitations': [],
  'GET /v1/projects/p1/members': { members_see: 'all', members: [] },
  'GET /v1/projects/p1/sound-list': { revision: 1, cues: [aCue('shield_hit', 'impact'), aCue('theme', 'music')] },
  'GET /v1/projects/p1/placeholders/countdown': {
    target: 'game',
    cues: 0,
    cues_left: 0,
    files: 0,
    left: 0,
    categories: [],
    next: null,
  },
  'GET /v1/projects/p1/pack': {
    target: 'game',
    targets: ['game'],
    files: 0,
    bytes: 0,
    masters_bytes: 0,
    cues_accepted: 0,
    cues_wanted: 2,
    missing: [],
  },
  'GET /v1/projects/p1/ci': {
    command: 'curl soundlist.pyz && python3 -I soundlist.pyz ci --target game assets/',
    lines: ['curl spec', 'audio-checks check --spec spec.toml assets/', 'curl report'],
  },
  'GET /v1/projects/p1/tokens': [],
  'GET /v1/projects/p1/builds': { items: [], next: null },
  'GET /v1/projects/p1/invitations': [],
  'GET /v1/projects/p1/approver-history': [
    { person: WHO.approver, reason: 'Knows the game', changer: WHO.producer, created_at: '2026-11-01T10:00:00Z' },
  ],
  'GET /v1/projects/p1/categories': [],
  'GET /v1/projects/p1/approval-settings': { blockers: 'none', checklists: [] },
  'GET /v1/projects/p1/deputies': { time_zone: 'UTC', today: '2026-11-20', deputies: [] },
  'GET /v1/studios/s1/people': members,
  'GET /v1/studios/s1/outbox': { can_send: false, mails: [] },
  'GET /v1/studios/s1/quotas': [],
  'POST /v1/projects/p1/spec/check-toml': ({ body }: { body: unknown }) => {
    const { toml, tables } = body as { toml?: string; tables?: unknown }
    return tried(toml ?? `# by form\n${JSON.stringify(tables)}`, tables ?? TABLES)
  },
  ...more,
})
