import { type Answers } from './server'

export const SHA = 'a'.repeat(64)
const cue = (name: string) => ({ id: name, label: 'SW-001', name })
const stated = (name: string, state: string, part: number, owed: number) => ({
  cue: cue(name),
  milestone: 'Alpha',
  state,
  was_cut: false,
  price_minor: 18_000,
  part_bp: part,
  owed_minor: owed,
  clause: 'kill_fee',
})
export const ENDING = {
  project_id: 'p1',
  contract_id: 'c1',
  title: 'Effects for Alpha',
  designer: { id: 'x3', name: 'Sound designer' },
  currency: 'USD',
  my_party: 'designer',
  state: 'forecast',
  notice: null,
  notice_days: 14,
  earliest_ends_on: '2026-12-01',
  deposit_at_end: 'stays',
  cues: [
    stated('radar_ping', 'accepted', 10_000, 18_000),
    stated('dock_clamp', 'in_work', 5_000, 9_000),
    stated('mine_arm', 'in_work', 5_000, 9_000),
    stated('warp_in', 'delivered', 7_500, 13_500),
  ],
  cues_minor: 49_500,
  deposit_minor: 10_000,
  rounds_minor: 0,
  extra_minor: 0,
  days_minor: 0,
  hours_minor: 0,
  retainer_minor: 0,
  due_now_minor: 28_000,
  figures: {
    agreed_minor: 82_000,
    accepted_minor: 59_500,
    paid_minor: 0,
    due_minor: 59_500,
    open_minor: 0,
    saved_minor: 22_500,
  },
  open_points: [],
  statement_sha256: null,
  settled_at: null,
  signed: [],
  signatures_needed: 2,
  may: { give_notice: true, withdraw: false, agree: false },
}
const NOTICE = {
  number: 1,
  party: 'studio',
  given_by: 'Producer',
  given_at: '2026-11-17T09:00:00Z',
  reason: 'The game is shelved.',
  ends_on: '2026-12-01',
}
export const GIVEN = {
  ...ENDING,
  state: 'notice',
  notice: NOTICE,
  statement_sha256: SHA,
  may: { give_notice: false, withdraw: true, agree: true },
}
export const DIFFERENCE = {
  changes: ['SW-025 shield_down is added to Beta at USD 225.00.'],
  cues_before: 23,
  cues_after: 24,
  price_before_minor: 704_250,
  price_after_minor: 726_750,
  milestones: [
    {
      name: 'Beta',
      is_deposit: false,
      amount_before_minor: 236_250,
      amount_after_minor: 258_750,
      due_before: '2026-12-18',
      due_after: '2026-12-16',
    },
  ],
  warnings: [
    { code: 'earlier-and-more', message: 'Beta moves up while work is added to it.', why: 'Dates are missed.' },
  ],
  advice: [],
  advice_gone: [],
}
export const ORDER = {
  number: 1,
  state: 'proposed',
  party: 'studio',
  proposed_by: 'Producer',
  proposed_at: '2026-11-15T09:00:00Z',
  reason: 'The level grew',
  begins_at_once: false,
  closed_at: null,
  close_reason: '',
  text_sha256: SHA,
  blocks: [],
  difference: DIFFERENCE,
  problems: [],
  signed: [],
  signatures_needed: 2,
  may: { agree: true, refuse: true, withdraw: false },
}
export const ORDERS = {
  project_id: 'p1',
  contract_id: 'c1',
  title: 'Effects for Alpha',
  currency: 'USD',
  my_party: 'designer',
  may_propose: true,
  extra_round_bp: 2_500,
  orders: [ORDER],
  offers: [],
  milestones: [{ id: 'm1', name: 'Beta', due_on: '2026-12-18' }],
  cues: [{ cue: cue('mine_arm'), price_minor: 18_000, round_minor: 4_500 }],
  caps: null,
  cues_to_add: [cue('shield_down')],
}
export const ME = { id: 'x3', name: 'Sound designer' }
const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  part: 'designer',
  cue_prefix: 'SW',
  is_producer: false,
  engagement_kind: 'contract',
}
export const amendmentAnswers = (more: Answers): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME },
  'GET /v1/me': { person: ME, email: 'designer@sound.example', studios: [], projects: [PROJECT] },
  ...more,
})
