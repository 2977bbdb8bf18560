import { CONTRACT as A_CONTRACT, MAY as A_MAY, VERSION as A_VERSION } from './contract'
import { type Answers } from './server'

const CLAUSES = [
  { key: 'parties', title: 'Parties', text: 'Between us.', stands: true },
  { key: 'rounds', title: 'Rounds', text: 'It includes {rounds_included} rounds.', stands: true },
]
export const VERSION = { ...A_VERSION, blocks: [], clauses: CLAUSES }
export const MAY = { ...A_MAY, amend: false }
export const CONTRACT = {
  ...A_CONTRACT,
  version: VERSION,
  redlines: null,
  signature_time: { first_sent_at: '2026-11-20T10:00:00Z', waits_since: '2026-11-20T10:00:00Z' },
  may: { ...MAY, request_change: true },
}
const same = (text: string, kind = 'text') => ({ kind, change: 'same', runs: [{ is_in: 'both', text }] })
const marked = (key: string, number: number | null, lines: object[], redline: object | null = null) => ({
  key,
  number,
  lines,
  counter_lines: [],
  redline,
})
export const UNMARKED = [
  marked('parties', 1, [same('Parties', 'head'), same('Between us.')]),
  marked('rounds', 2, [same('Rounds', 'head'), same('It includes 2 rounds.')]),
]
const redline = (number: number, clause: string, more: object = {}) => ({
  number,
  kind: 'replace',
  clause_key: clause,
  wording: { title: 'Rounds', text: 'It includes four rounds.', terms: {} },
  comment: 'Two are few.',
  answer: null,
  ...more,
})
const CHANGED = {
  kind: 'text',
  change: 'changed',
  runs: [
    { is_in: 'both', text: 'It includes ' },
    { is_in: 'earlier', text: '2' },
    { is_in: 'later', text: 'four' },
    { is_in: 'both', text: ' rounds.' },
  ],
}
const ADDED = { kind: 'text', change: 'added', runs: [{ is_in: 'later', text: 'At four.' }] }
export const round = (answers: (object | null)[] = [null, null], more: object = {}) => ({
  number: 1,
  version: 2,
  sent_version: null,
  note: 'See you.',
  by: 'Sound designer',
  at: '2026-11-21T10:00:00Z',
  unanswered: answers.filter((answer) => answer === null).length,
  clauses: [
    UNMARKED[0],
    marked('rounds', 2, [same('Rounds', 'head'), CHANGED], redline(1, 'rounds', { answer: answers[0] })),
    marked('own_tea_2', null, [ADDED], {
      ...redline(2, 'own_tea_2', { answer: answers[1] }),
      kind: 'insert',
      wording: { title: 'Tea', text: 'At four.', terms: {} },
      comment: '',
    }),
  ],
  ...more,
})
export const given = (kind: string, more: object = {}) => ({
  kind,
  wording: null,
  comment: '',
  by: 'Producer',
  at: '2026-11-22T10:00:00Z',
  ...more,
})
export const page = (of: object | null, mayAnswer = false) => ({
  contract_id: 'c1',
  project_id: 'p1',
  rounds: of === null ? 0 : 1,
  round: of,
  may_answer: mayAnswer,
})
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
const ME = { person: { id: 'x3', name: 'Someone' }, email: 'x@sound.example', studios: [], projects: [PROJECT] }
const LIBRARY = {
  kind: 'single',
  notice: '',
  variables: {},
  clauses: [
    {
      ...{ key: 'rounds', title: 'Rounds', text: '', stands: true, why: '', music: false, instead_of: null },
      terms: [{ name: 'rounds_included', default: 2, label: 'Rounds of changes', min: 0, max: 20, choices: [] }],
    },
  ],
}
export const redlineAnswers = (more: Answers = {}): Answers => ({
  'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
  'GET /v1/me': ME,
  'GET /v1/contracts/c1': CONTRACT,
  'GET /v1/contracts/c1/redlines': page(null),
  'POST /v1/contracts/c1/redline-preview': { clauses: UNMARKED, problems: [] },
  'GET /v1/contract-library/single': LIBRARY,
  ...more,
})
export const PAGE = '/projects/p1/contracts/c1/redlines'
