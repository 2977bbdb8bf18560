import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { type Answers, refusal, serve } from '@/test/server'

import type { PreviewCue, Spec } from './api'
import { factsOf, shapeOf, sumOf } from './words'

const CUE: PreviewCue = {
  number: 3,
  label: 'SW-003',
  name: 'laser_fire',
  file_name: 'laser_fire',
  category: 'weapon',
  description: 'Thin and bright, must not tire at five a second.',
  use: 'Player’s turret',
  duration_s: 0.3,
  duration_min_s: null,
  duration_max_s: null,
  loop: false,
  channels: null,
  variations: 4,
  state: 'locked',
}
const WHALE: PreviewCue = { ...CUE, number: 21, label: 'SW-021', name: 'void_whale', variations: 1, state: 'concept' }
const SPEC: Spec = {
  name: 'Shield Wing',
  accept: {
    containers: ['wav'],
    encodings: ['pcm'],
    sample_rates_hz: [44_100, 48_000, 96_000],
    bit_depths: [16, 24],
    channels: [1, 2],
    layouts: null,
    duration_s: { min: 0.01, max: 30 },
  },
  limits: {
    sample_peak_dbfs: -0.1,
    true_peak_dbtp: null,
    dc_offset_percent: 1,
    silence_below_dbfs: -90,
    head_silence_ms: 5,
    tail_silence_ms: null,
    edge_silence_below_dbfs: -60,
    tolerance_db: 0.05,
    loudness_lufs: { min: -40, max: -10 },
    noise_floor_dbfs: null,
    mono_loss_db: null,
    others: {},
  },
  naming: { pattern: null, extension: '.wav', tokens: [], separator: '_', grammar: null, portable: true },
  required_metadata: [],
  engine: { adds: ['reverb'] },
  targets: {},
  checks: {},
  categories: [],
}
const INVITATION = {
  project: { name: 'Shield Wing', description: 'Space strategy for PC and handheld.', cue_prefix: 'SW' },
  studio_name: 'Shield Wing studio',
  kind: 'contract',
  note: 'Start with the alarms.',
  email: 'designer@sound.example',
  invited_by_name: 'Producer',
  has_account: false,
  expires_at: '2027-01-02T09:00:00Z',
  cues: [CUE, WHALE],
  accepted: false,
  nda_needed: false,
  spec: SPEC,
}
const NOBODY = { signed_in: false, demo: false, person: null }
const ME = {
  person: { id: 'x3', name: 'Sound designer' },
  email: 'designer@sound.example',
  studios: [],
  projects: [],
}
const given = (more: Answers = {}): Answers => ({
  'GET /v1/session': NOBODY,
  'GET /v1/invitations/s3cret': INVITATION,
  ...more,
})

describe('the link', () => {
  test('shows the project, its list and how files must come, and asks for nothing', async () => {
    const { asked } = serve(given())
    openApp('/invitation/s3cret')
    await screen.findByRole('heading', { level: 1, name: 'Shield Wing' })
    expect(
      screen.getByText('Producer of Shield Wing studio invites you to make its sounds as a contractor.'),
    ).toBeVisible()
    expect(screen.getByText('Start with the alarms.')).toBeVisible()
    const row = within(screen.getByRole('table', { name: 'Sound list' })).getByRole('row', { name: /laser_fire/ })
    expect(row).toHaveTextContent('Player’s turret. Thin and bright, must not tire at five a second.')
    expect(row).toHaveTextContent('0.30 s')
    expect(row).toHaveTextContent('set of 4')
    expect(screen.getByText('2 cues, 5 files, 1 not final yet')).toBeVisible()
    expect(screen.getByText('44.1 kHz, 48 kHz or 96 kHz')).toBeVisible()
    expect(screen.queryByRole('textbox')).not.toBeInTheDocument()
    expect(new Set(asked.map(({ method }) => method))).toEqual(new Set(['GET']))
  })

  test('shows no list before the NDA that the project asks for', async () => {
    serve(given({ 'GET /v1/invitations/s3cret': { ...INVITATION, nda_needed: true, cues: [], spec: null } }))
    openApp('/invitation/s3cret')
    expect(await screen.findByText('Sign the NDA to see the sound list')).toBeVisible()
    expect(screen.queryByRole('heading', { name: 'File requirements' })).not.toBeInTheDocument()
  })

  test('one that is too old says so, and what to do', async () => {
    serve(
      given({ 'GET /v1/invitations/s3cret': refusal(404, 'invitation-not-found', 'This invitation is not there.') }),
    )
    openApp('/invitation/s3cret')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'This invitation is not there. Ask the person who invited you for a new link.',
    )
  })

  test('a list without cues says what comes next', async () => {
    serve(given({ 'GET /v1/invitations/s3cret': { ...INVITATION, cues: [] } }))
    openApp('/invitation/s3cret')
    expect(await screen.findByRole('heading', { name: 'The sound list is empty' })).toBeInTheDocument()
  })
})

describe('start delivering', () => {
  test('asks for a name and a password, and leads to the desk', async () => {
    const server = serve(
      given({
        'POST /v1/invitations/s3cret/accept': () => {
          Object.assign(server.answers, {
            'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
            'GET /v1/me': ME,
          })
          return { person: { ...ME.person, email: ME.email }, project_id: 'p1', engagement: {} }
        },
      }),
    )
    const user = userEvent.setup()
    const app = openApp('/invitation/s3cret')
    await user.click(await screen.findByRole('button', { name: 'Start delivering' }))
    expect(screen.getByLabelText('Your name')).toHaveFocus()
    await user.type(screen.getByLabelText('Your name'), 'Sound designer')
    await user.type(screen.getByLabelText('New password'), 'four words of sound')
    await user.click(screen.getByRole('button', { name: 'Create account and go to your desk' }))
    await waitFor(() => expect(app.at()).toBe('/projects/p1/desk'))
    const sent = server.asked.find(({ method }) => method === 'POST')
    expect(sent?.body).toEqual({ name: 'Sound designer', password: 'four words of sound' })
    expect(sent?.headers.get('X-CSRF-Token')).toBe('token-of-the-page')
  })

  test('a weak password is said at its field, the name stays', async () => {
    const weak = { where: 'password', message: 'choose a password of At least 10 characters' }
    serve(
      given({
        'POST /v1/invitations/s3cret/accept': refusal(422, 'password-too-weak', weak.message, { errors: [weak] }),
      }),
    )
    const user = userEvent.setup()
    openApp('/invitation/s3cret')
    await user.click(await screen.findByRole('button', { name: 'Start delivering' }))
    await user.type(screen.getByLabelText('Your name'), 'Sound designer')
    await user.type(screen.getByLabelText('New password'), 'short')
    await user.click(screen.getByRole('button', { name: 'Create account and go to your desk' }))
    expect(await screen.findByText('Choose a password of At least 10 characters.')).toBeVisible()
    expect(screen.getByLabelText('Your name')).toHaveValue('Sound designer')
  })

  test('who has an account gives its password alone', async () => {
    const { asked } = serve(
      given({
        'GET /v1/invitations/s3cret': { ...INVITATION, has_account: true },
        'POST /v1/invitations/s3cret/accept': refusal(401, 'sign-in-needed', 'the password is not the one'),
      }),
    )
    const user = userEvent.setup()
    openApp('/invitation/s3cret')
    await user.click(await screen.findByRole('button', { name: 'Start delivering' }))
    expect(screen.queryByLabelText('Your name')).not.toBeInTheDocument()
    await user.type(screen.getByLabelText('Password'), 'not the one')
    await user.click(screen.getByRole('button', { name: 'Sign in and go to your desk' }))
    expect(await screen.findByRole('alert')).toHaveTextContent('The password is not the one')
    expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: null, password: 'not the one' })
  })

  test('who is signed in already only says yes', async () => {
    const { asked } = serve(
      given({
        'GET /v1/session': { signed_in: true, demo: false, person: ME.person },
        'GET /v1/me': ME,
        'POST /v1/invitations/s3cret/accept': { person: {}, project_id: 'p1', engagement: {} },
      }),
    )
    const user = userEvent.setup()
    openApp('/invitation/s3cret')
    await user.click(await screen.findByRole('button', { name: 'Start delivering' }))
    expect(await screen.findByText('You are signed in as Sound designer.')).toBeVisible()
    await user.click(screen.getByRole('button', { name: 'Go to your desk' }))
    await waitFor(() =>
      expect(asked.find(({ method }) => method === 'POST')?.body).toEqual({ name: null, password: null }),
    )
  })
})

describe('in words', () => {
  test('a spec says what it limits, and leaves out what it leaves open', () => {
    expect(Object.fromEntries(factsOf(SPEC).map(({ term, text }) => [term, text]))).toEqual({
      Container: 'WAV',
      'Sample rate': '44.1 kHz, 48 kHz or 96 kHz',
      'Bit depth': '16 or 24 bit',
      Channels: 'mono or stereo',
      Length: '0.01 s to 30.00 s',
      'Sample peak': 'at most −0.1 dBFS',
      Loudness: '−40.0 to −10.0 LUFS',
      'Leading silence': 'at most 5 ms',
      'File names': 'as in the list, ending in .wav',
      'Applied in engine': 'reverb; deliver dry',
    })
  })

  test('a cut cue asks for nothing', () => {
    expect(sumOf([CUE, WHALE, { ...CUE, state: 'cut' }])).toEqual({ cues: 2, files: 5, settled: 1 })
  })

  test.each([
    [{ variations: 1, loop: false }, ''],
    [{ variations: 1, loop: true }, 'loop'],
    [{ variations: 4, loop: true }, 'set of 4, loop'],
  ])('%j is "%s"', (more, said) => {
    expect(shapeOf({ ...CUE, ...more })).toBe(said)
  })
})
