import { type Answers } from './server'

export const STUDIO = { id: 's1', name: 'Shield Wing studio', roles: ['producer'] }
const PROJECT = {
  id: 'p1',
  name: 'Shield Wing',
  studio_id: 's1',
  studio_name: 'Shield Wing studio',
  cue_prefix: 'SW',
  part: 'team',
  is_producer: true,
  is_liaison: false,
  is_approver: false,
  engagement_kind: null,
}
export const PRODUCER = {
  person: { id: 'x1', name: 'Producer' },
  email: 'producer@studio.example',
  email_verified_at: '2026-11-20T09:00:00Z' as string | null,
  studios: [STUDIO],
  projects: [PROJECT],
}
export const DESIGNER = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  email_verified_at: null as string | null,
  studios: [],
  projects: [{ ...PROJECT, part: 'designer', is_producer: false, engagement_kind: 'contract' }],
}
const EMPTY_DESK = {
  came_back: [],
  to_make: [],
  with_approver: [],
  with_approver_files: 0,
  accepted: 0,
  cues: 0,
  unmatched: 0,
  checking: 0,
  questions: [],
}
const SIGN_INS = [
  {
    id: 'n1',
    device: 'Firefox on Linux',
    place: '192.0.2.7',
    is_current: true,
    created_at: '2026-11-20T09:00:00Z',
    last_seen_at: '2026-11-23T09:00:00Z',
    expires_at: '2026-12-20T09:00:00Z',
  },
  {
    id: 'n2',
    device: 'Safari on iOS',
    place: '192.0.2.8',
    is_current: false,
    created_at: '2026-11-19T09:00:00Z',
    last_seen_at: '2026-11-22T09:00:00Z',
    expires_at: '2026-12-19T09:00:00Z',
  },
  {
    id: 'n3',
    device: '',
    place: '192.0.2.9',
    is_current: false,
    created_at: '2026-11-18T09:00:00Z',
    last_seen_at: '2026-11-21T09:00:00Z',
    expires_at: '2026-12-18T09:00:00Z',
  },
]
export const AT_ONCE = { open: true, by_mail: false, setup_code: false }
export const NOBODY = { signed_in: false, demo: false, person: null }
export const signedIn = (me: typeof PRODUCER | typeof DESIGNER, demo = false) => ({
  signed_in: true,
  demo,
  person: me.person,
})

/** The answers that every page of a signed-in person requests. */
export const asPerson = (me: typeof PRODUCER | typeof DESIGNER, more: Answers = {}, demo = false): Answers => ({
  'GET /v1/session': signedIn(me, demo),
  'GET /v1/me': me,
  'GET /v1/review-queue/count': { cues: 0, is_all: true },
  'GET /v1/projects/p1/desk': EMPTY_DESK,
  'GET /v1/me/sign-ins': SIGN_INS,
  'GET /v1/me/desk-tokens': [],
  'GET /v1/studios/s1/second-factor': { required_for: [] },
  'GET /v1/studios/s1/sign-in-provider': {
    issuer: null,
    client_id: null,
    domains: [],
    redirect_uri: 'https://sounds.example/sign-in/provider',
  },
  'GET /v1/me/passkeys': [],
  'GET /v1/me/email-change': null,
  'GET /v1/me/second-factors': { totp_since: null, recovery_codes_left: 0 },
  ...more,
})
