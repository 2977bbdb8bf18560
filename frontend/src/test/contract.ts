import { type Answers } from './server'

const span = (text: string, field = '') => ({ text, strong: false, emphatic: false, field })
export const block = (kind: 'head' | 'text' | 'item', text: string, level = 0) => ({
  kind,
  level,
  spans: [span(text)],
  rows: [],
})
/** A paragraph with the figures that a preview marks: ['It includes ', ['rounds_included', '2'], ' rounds.']. */
export const marked = (...words: (string | [field: string, text: string])[]) => ({
  ...block('text', ''),
  spans: words.map((word) => (typeof word === 'string' ? span(word) : span(word[1], word[0]))),
})
const CLAUSES = [
  { key: 'rounds', title: 'Rounds', text: 'It includes {rounds_included} rounds.', stands: true },
  { key: 'bonus', title: 'Bonus', text: 'A bonus.', stands: false },
]
export const VERSION = {
  number: 2,
  note: '',
  author: { id: 'x1', name: 'Producer' },
  created_at: '2026-11-20T09:00:00Z',
  sent_at: '2026-11-20T10:00:00Z',
  text_sha256: 'a'.repeat(64),
  pdf_sha256: 'b'.repeat(64),
  blocks: [block('head', 'Effects', 1), block('head', '1. Rounds', 2), block('text', 'It includes 2 rounds.')],
  clauses: CLAUSES,
  terms: { rounds_included: 2 },
}
/** The version as a list of versions has it. */
const BRIEF = Object.fromEntries(Object.entries(VERSION).filter(([name]) => !/^(blocks|clauses|terms)$/.test(name)))
export const MAY = { change: false, send: false, recall: false, request_change: false, accept: false, end: false }
export const CONTRACT = {
  id: 'c1',
  project_id: 'p1',
  number: 1,
  title: 'Effects for Alpha',
  kind: 'single',
  state: 'sent',
  designer: { id: 'x3', name: 'Sound designer' },
  engagement_id: 'e1',
  framework_id: null,
  currency: 'USD',
  release_clause: 'per_cue',
  deposit_bp: 2000,
  holdback_bp: 0,
  created_at: '2026-11-19T09:00:00Z',
  agreed_at: null,
  ended_at: null,
  end_reason: null,
  my_party: 'designer',
  waits_for: ['studio', 'designer'],
  studio_name: 'Shield Wing studio',
  version: VERSION,
  acceptances: [],
  signers: [],
  signs_first: null,
  change_requested: null,
  joint: [],
  may: { ...MAY, request_change: true, accept: true, end: true },
}
export const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  part: 'designer',
  cue_prefix: 'SW',
  is_producer: false,
  engagement_kind: 'contract',
}
export const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  studios: [],
  projects: [PROJECT],
}
/** A contract under which nothing was delivered yet. */
export const NO_MASTERS = {
  years: 5,
  last_delivery_on: null,
  masters: 0,
  ends_on: null,
  announced_at: null,
  obstacles: [],
  kept_by: null,
  deleted_at: null,
}

export const contractAnswers = (more: Answers = {}): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
  'GET /v1/me': ME,
  'GET /v1/contracts/c1': CONTRACT,
  'GET /v1/contracts/c1/master-retention': NO_MASTERS,
  'GET /v1/contracts/c1/versions': [BRIEF, { ...BRIEF, number: 1 }],
  ...more,
})
export const PAGE = '/projects/p1/contracts/c1'

export const accepted = (party: string, name: string) => ({
  party,
  name,
  email: 'n@sound.example',
  drawing: null,
  accepted_at: '2026-11-20T11:00:00Z',
})
