import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'

import { dismissToast } from '@/app/toast'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { anOverview, aProject, inProject, people } from '@/test/project'
import { answer, type Asked, refusal, serve } from '@/test/server'

const copied: string[] = []

beforeEach(() => {
  document.cookie = 'soundlist_csrf=token-of-the-page'
  sessionStorage.clear()
  dismissToast()
  vi.stubGlobal('AudioContext', HandContext)
  copied.length = 0
})
afterEach(() => vi.unstubAllGlobals())

/** The clipboard of user-event, which keeps what is copied. */
function user() {
  const set = userEvent.setup()
  vi.spyOn(navigator.clipboard, 'writeText').mockImplementation((text) => {
    copied.push(text)
    return Promise.resolve()
  })
  return set
}
const wrote = (asked: readonly Asked[], what: string) =>
  asked.filter(({ method, path }) => `${method} ${path}` === what)

const build = (label: string, rejected: number, warnings: number, files = 12) => ({
  id: `b${label}`,
  label,
  commit: '',
  target: 'game',
  files,
  rejected,
  warnings,
  created_at: '2026-11-20T10:00:00Z',
})
const finding = (severity: string, message: string, more = {}) => ({
  code: 'a:b',
  severity,
  message,
  fix: 'render it again',
  ...more,
})
const REPORT = {
  files: [
    {
      path: 'assets/airlock.wav',
      verdict: 'rejected',
      findings: [
        finding('error', 'sample rate 44100 Hz, accepted 48000 Hz'),
        finding('warning', 'true peak 0.6 dBTP, limit -1 dBTP'),
      ],
    },
    {
      path: 'assets/let_through.wav',
      verdict: 'rejected',
      findings: [finding('error', 'sample peak 0.00 dBFS, limit -0.1 dBFS', { waived: true })],
    },
    { path: 'assets/broken.wav', verdict: 'unreadable', findings: [] },
    { path: 'assets/fine.wav', verdict: 'conforming', findings: [] },
  ],
}

describe('the project page', () => {
  test('one cell a cue, the palette first; a cell says its state and leads to where it is dealt with', async () => {
    serve(inProject())
    openApp('/projects/p1')
    const palette = await screen.findByRole('list', { name: 'Palette' })
    const rest = screen.getByRole('list', { name: 'The rest of the list' })
    expect(palette.compareDocumentPosition(rest)).toBe(Node.DOCUMENT_POSITION_FOLLOWING)
    expect(within(palette).getByRole('link', { name: 'SW-002 ui_confirm: Accepted' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list/cues/c2',
    )
    expect(within(rest).getByRole('link', { name: 'SW-001 shield_hit: To review' })).toHaveAttribute(
      'href',
      '/projects/p1/review/c1',
    )
    expect(screen.getByText('1 accepted, 1 waits for the approver')).toBeVisible()
    // The cut cue is drawn and not counted.
    expect(within(rest).getAllByRole('link')).toHaveLength(2)
    expect(screen.getByText('0 of 1 accepted')).toBeVisible()
  })

  test('the spec in words: what a master may be, limits with what follows, what is made of it', async () => {
    serve(inProject())
    openApp('/projects/p1')
    const spec = await screen.findByRole('region', { name: 'Delivery spec' })
    expect(await within(spec).findByText('48 or 96 kHz')).toBeVisible()
    expect(within(spec).getByText('0.01–30 s')).toBeVisible()
    expect(within(spec).getByText('−1.0 dBTP')).toHaveTextContent('−1.0 dBTP, warns')
    expect(within(spec).getByText('−0.1 dBFS')).toHaveTextContent('−0.1 dBFS, returns')
    expect(within(spec).getByText('48 kHz, 16 bit, as master')).toBeVisible()
    expect(await within(spec).findByRole('row', { name: 'music 1 music up to 300 s' })).toBeVisible()
    expect(within(spec).getByText(/As above: impact \(1\)/)).toBeVisible()
  })

  test('`e` opens the spec for those who speak for the team', async () => {
    serve(inProject())
    const { at } = openApp('/projects/p1')
    expect(await screen.findByRole('link', { name: /Change/ })).toBeVisible()
    await userEvent.keyboard('e')
    await waitFor(() => expect(at()).toBe('/projects/p1/spec'))
  })

  test('a designer sees cues, spec and what happened, and nothing of builds, packs and people', async () => {
    const { asked } = serve(inProject('designer', { 'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk') }))
    openApp('/projects/p1')
    expect(await screen.findByText('Audio director, decides')).toBeVisible()
    expect(await screen.findByRole('link', { name: 'SW-001 shield_hit: To review' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list/cues/c1',
    )
    expect(await screen.findByText('48 or 96 kHz')).toBeVisible()
    for (const name of ['Builds', 'Approved pack']) expect(screen.queryByRole('region', { name })).toBeNull()
    expect(screen.queryByRole('link', { name: 'People' })).toBeNull()
    expect(screen.queryByRole('link', { name: /Change/ })).toBeNull()
    expect(asked.some(({ path }) => /builds|pack|tokens|people/.test(path))).toBe(false)
  })

  test('an empty project says what to do first', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1/overview': anOverview({ steps: [], counts: {} }) }))
    openApp('/projects/p1')
    expect(await screen.findByRole('heading', { name: 'Nothing is asked yet.' })).toBeVisible()
    expect(screen.getByRole('link', { name: 'Import the list' })).toHaveAttribute(
      'href',
      '/projects/p1/sound-list/import',
    )
    expect(screen.getByRole('link', { name: 'Invite a designer' })).toHaveAttribute('href', '/projects/p1/people')
    expect(screen.getByText('No build has reported yet.')).toBeVisible()
    expect(await screen.findByText('Nothing is accepted yet.')).toBeVisible()
  })

  test('a list that nobody works on asks for a designer', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1': aProject('producer', { engagements: [] }) }))
    openApp('/projects/p1')
    expect(await screen.findByText('Nobody makes these sounds yet.')).toBeVisible()
  })

  test('a project that is not there says so', async () => {
    serve(inProject('producer', { 'GET /v1/projects/p1': refusal(404, 'project-not-found', 'no such project') }))
    openApp('/projects/p1')
    expect(await screen.findByRole('heading', { name: 'Nothing stands at this address.' })).toBeVisible()
  })

  test('axe finds nothing', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/overview': anOverview({ builds: [build('482', 1, 0)] }),
        'GET /v1/builds/b482': { report: REPORT },
      }),
    )
    openApp('/projects/p1')
    await screen.findByText('assets/airlock.wav')
    const { violations } = await axe.run(document.body, {
      rules: { 'color-contrast': { enabled: false }, region: { enabled: false } },
    })
    expect(violations.map(({ id }) => id)).toEqual([])
  })
})

describe('builds', () => {
  const withBuilds = () =>
    inProject('producer', {
      'GET /v1/projects/p1/overview': anOverview({
        builds: [build('482', 2, 0), build('481', 0, 3), build('480', 0, 0)],
      }),
      'GET /v1/builds/b482': { report: REPORT },
    })

  test('the squares are told in words; the latest names what it refuses, and a waived file is none of it', async () => {
    serve(withBuilds())
    openApp('/projects/p1')
    expect(await screen.findByRole('img', { name: '3 builds: 1 passed, 1 with warnings, 1 refused' })).toBeVisible()
    const refused = await screen.findByRole('list', { name: 'Refused files' })
    expect(within(refused).getByText('assets/airlock.wav')).toBeVisible()
    expect(within(refused).getByText('Sample rate 44100 Hz')).toBeVisible()
    expect(within(refused).getByText(', accepted 48000 Hz. Render it again.')).toBeVisible()
    expect(within(refused).getByText('Cannot be read')).toBeVisible()
    expect(within(refused).queryByText('assets/let_through.wav')).toBeNull()
    expect(within(refused).queryByText(/true peak/i)).toBeNull()
  })

  test('the copy button takes every line, not only the one that is shown', async () => {
    serve(withBuilds())
    const press = user()
    openApp('/projects/p1')
    await press.click(await screen.findByRole('button', { name: 'Copy all lines for CI' }))
    expect(copied).toEqual(['curl spec\naudio-checks check --spec spec.toml assets/\ncurl report'])
  })

  test('a token’s secret is shown once, with what it is for', async () => {
    const made = {
      id: 't1',
      name: 'Nightly',
      scopes: ['spec:read'],
      creator: people.producer,
      created_at: '2026-11-20T10:00:00Z',
      last_used_at: null,
      revoked_at: null,
    }
    const { asked } = serve({
      ...withBuilds(),
      'POST /v1/projects/p1/tokens': answer({ ...made, secret: 'slt_once' }, 201),
    })
    const press = user()
    openApp('/projects/p1')
    await press.click(await screen.findByRole('button', { name: 'Make a token' }))
    const name = screen.getByLabelText('What the token is for')
    await press.clear(name)
    await press.type(name, 'Nightly')
    await press.click(screen.getByRole('button', { name: 'Make the token' }))
    expect(await screen.findByText('slt_once')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/tokens')[0]?.body).toEqual({
      name: 'Nightly',
      scopes: ['spec:read', 'list:read', 'checks:write', 'manifest:read'],
    })
    await press.click(screen.getByRole('button', { name: 'Copy the secret' }))
    expect(copied).toEqual(['slt_once'])
    await press.click(screen.getByRole('button', { name: 'It is kept' }))
    expect(screen.queryByText('slt_once')).toBeNull()
  })

  test('a token is revoked only after it was said what that does', async () => {
    const token = {
      id: 't1',
      name: 'Nightly',
      scopes: ['spec:read'],
      creator: people.producer,
      created_at: '2026-11-20T10:00:00Z',
      last_used_at: null,
      revoked_at: null,
    }
    const { asked, answers } = serve({
      ...withBuilds(),
      'GET /v1/projects/p1/builds': { items: [build('482', 2, 0)], next: null },
      'GET /v1/projects/p1/tokens': [token],
      'DELETE /v1/projects/p1/tokens/t1': answer(null, 204),
    })
    const press = user()
    openApp('/projects/p1/builds')
    await press.click(await screen.findByRole('button', { name: 'Revoke Nightly' }))
    expect(wrote(asked, 'DELETE /v1/projects/p1/tokens/t1')).toHaveLength(0)
    answers['GET /v1/projects/p1/tokens'] = [{ ...token, revoked_at: '2026-11-21T10:00:00Z' }]
    await press.click(screen.getByRole('button', { name: 'Revoke “Nightly”' }))
    expect(await screen.findByText('Worthless')).toBeVisible()
    expect(wrote(asked, 'DELETE /v1/projects/p1/tokens/t1')).toHaveLength(1)
  })
})

describe('the approved pack', () => {
  const PACK = {
    target: 'game',
    targets: ['game', 'handheld'],
    files: 3,
    bytes: 5_329_528,
    masters_bytes: 6_584_164,
    cues_accepted: 2,
    cues_wanted: 5,
    missing: [],
  }

  test('each target with its files, its download with masters or without, and its key', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/pack': ({ query }: Asked) =>
          query.get('target') === 'handheld'
            ? {
                ...PACK,
                target: 'handheld',
                files: 2,
                bytes: 1_400_000,
                missing: [
                  {
                    cue_id: 'c1',
                    label: 'SW-001',
                    name: 'shield_hit',
                    file_name: 'shield_hit.wav',
                    reason: 'not made yet',
                  },
                ],
              }
            : PACK,
      }),
    )
    openApp('/projects/p1')
    const pack = await screen.findByRole('region', { name: 'Approved pack' })
    expect(await within(pack).findByText('2 of 5 cues')).toBeVisible()
    expect(within(pack).getByText('3 files, 5.3 MB')).toBeVisible()
    const game = within(pack).getByRole('link', { name: 'Download game' })
    expect(game).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=game')
    expect(within(pack).getByRole('link', { name: 'Documentation key of game as XLSX' })).toHaveAttribute(
      'href',
      '/v1/projects/p1/documentation-key.xlsx?target=game',
    )
    // What is missing is named, and its download leaves it out rather than being refused.
    expect(within(pack).getByText('1 accepted file missing')).toBeVisible()
    const handheld = within(pack).getByRole('link', { name: 'Download handheld without 1 missing file' })
    expect(handheld).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=handheld&allow_missing=true')
    await userEvent.click(within(pack).getByRole('checkbox', { name: 'With masters, 6.6 MB more' }))
    expect(game).toHaveAttribute('href', '/v1/projects/p1/pack.zip?target=game&masters=true')
  })
})

describe('placeholders', () => {
  const NEXT = {
    cue_id: 'c7',
    cue: 'SW-007',
    name: 'mine_arm',
    variation: 1,
    path: 'weapon/mine_arm.wav',
    category: 'weapon',
    state: 'missing',
    spoken: false,
    refusal: null,
  }
  const COUNTDOWN = {
    target: 'game',
    cues: 12,
    cues_left: 4,
    files: 20,
    left: 6,
    categories: [
      { category: '', files: 2, left: 1 },
      { category: 'ui', files: 8, left: 0 },
      { category: 'weapon', files: 10, left: 5 },
    ],
    next: NEXT,
  }
  const shown = async (countdown: unknown) => {
    serve(inProject('producer', { 'GET /v1/projects/p1/placeholders/countdown': countdown }))
    openApp('/projects/p1')
    return screen.findByRole('region', { name: 'Placeholders' })
  }

  test('count down by category, with the next to record', async () => {
    const card = await shown(COUNTDOWN)
    expect(await within(card).findByText('4 of 12 cues without an accepted sound')).toBeVisible()
    expect(within(card).getByRole('img', { name: '14 of 20 files have an accepted sound' })).toBeVisible()
    expect(
      within(card)
        .getAllByRole('listitem')
        .map((each) => each.textContent),
    ).toEqual(['without a category1 of 2 files', 'weapon5 of 10 files'])
    const next = within(card).getByRole('link', { name: 'mine_arm' })
    expect(next).toHaveAttribute('href', '/projects/p1/sound-list/cues/c7')
    expect(card).toHaveTextContent('SW-007 weapon/mine_arm.wav')
    expect(within(card).getByRole('link', { name: /^The register/ })).toHaveAttribute(
      'href',
      '/projects/p1/placeholders',
    )
  })

  test('that are all under way leave nothing to record', async () => {
    const card = await shown({ ...COUNTDOWN, next: null })
    expect(await within(card).findByText('Of all that is left a version is under way.')).toBeVisible()
  })

  test('that are all replaced are said to be', async () => {
    const card = await shown({ ...COUNTDOWN, cues_left: 0, left: 0, next: null })
    expect(await within(card).findByText('none, every cue is accepted')).toBeVisible()
    expect(within(card).queryByText(/under way/)).toBeNull()
  })

  test('of a spec without a target are not spoken of', async () => {
    serve(
      inProject('producer', {
        'GET /v1/projects/p1/placeholders/countdown': refusal(422, 'target-unknown', 'the spec has no target'),
      }),
    )
    openApp('/projects/p1')
    await screen.findByRole('region', { name: 'Approved pack' })
    await waitFor(() => expect(screen.queryByRole('region', { name: 'Placeholders' })).toBeNull())
  })
})

describe('projects', () => {
  const firstTime = () => {
    const answers = inProject()
    return { ...answers, 'GET /v1/me': { ...(answers['GET /v1/me'] as object), projects: [] } }
  }

  test('a producer without a project begins by opening one, and is told why', async () => {
    serve(firstTime())
    const { at } = openApp('/projects')
    expect(await screen.findByRole('heading', { name: 'New project' })).toBeVisible()
    expect(at()).toBe('/projects/new')
    expect(screen.getByText(/You have no project yet, so you begin here/)).toBeVisible()
  })

  test('the prefix follows the name until it is typed; the new project opens on its list', async () => {
    const { asked } = serve({
      ...firstTime(),
      'POST /v1/projects': answer({ ...aProject(), id: 'p9' }, 201),
      'GET /v1/projects/p9/sound-list': { revision: 0, cues: [] },
    })
    const { at } = openApp('/projects/new')
    await userEvent.type(await screen.findByLabelText('Name of the game'), 'Deep Field')
    expect(screen.getByLabelText('Prefix of cue numbers')).toHaveValue('DF')
    await userEvent.clear(screen.getByLabelText('Prefix of cue numbers'))
    await userEvent.type(screen.getByLabelText('Prefix of cue numbers'), 'dfl')
    await userEvent.type(screen.getByLabelText('Name of the game'), ' Two')
    expect(screen.getByLabelText('Prefix of cue numbers')).toHaveValue('DFL')
    await userEvent.click(screen.getByRole('radio', { name: '48 kHz game' }))
    await userEvent.click(screen.getByRole('button', { name: 'Open the project' }))
    await waitFor(() => expect(at()).toBe('/projects/p9/sound-list'))
    expect(wrote(asked, 'POST /v1/projects')[0]?.body).toEqual({
      studio_id: 's1',
      name: 'Deep Field Two',
      cue_prefix: 'DFL',
      description: '',
      preset: '48k',
    })
  })

  test('a refused name stands at its field, and nothing typed is lost', async () => {
    const message = 'must have at least 1 character'
    serve({
      ...firstTime(),
      'POST /v1/projects': refusal(422, 'invalid', 'a field does not fit', { errors: [{ where: 'name', message }] }),
    })
    openApp('/projects/new')
    await userEvent.type(await screen.findByLabelText(/What game is it/), 'A game of rivers')
    await userEvent.click(screen.getByRole('button', { name: 'Open the project' }))
    expect(await screen.findByText('Must have at least 1 character.')).toBeVisible()
    expect(screen.getByLabelText('Name of the game')).toHaveAccessibleDescription('Must have at least 1 character.')
    expect(screen.getByLabelText(/What game is it/)).toHaveValue('A game of rivers')
  })

  test('who opens no projects is told who does', async () => {
    serve(inProject('reviewer'))
    openApp('/projects/new')
    expect(await screen.findByRole('heading', { name: 'A producer opens projects.' })).toBeVisible()
    expect(screen.queryByRole('button', { name: 'Open the project' })).toBeNull()
  })

  test('the list tells of each what one is in it; those put away stand apart', async () => {
    const { asked } = serve({
      ...inProject(),
      'GET /v1/projects': ({ query }: Asked) => ({
        items:
          query.get('archived') === 'true' ? [] : [aProject(), aProject('designer', { id: 'p2', name: 'Deep Field' })],
        next: null,
      }),
    })
    openApp('/projects')
    const rows = within(await screen.findByRole('list', { name: 'Projects' })).getAllByRole('listitem')
    expect(rows[0]).toHaveTextContent(/Shield Wing.*you run it.*Audio director decides/)
    expect(rows[1]).toHaveTextContent(/Deep Field.*you make its sounds, by contract/)
    await userEvent.click(screen.getByRole('button', { name: 'Put away' }))
    expect(await screen.findByText('Nothing is put away.')).toBeVisible()
    expect(wrote(asked, 'GET /v1/projects').at(-1)?.query.get('archived')).toBe('true')
  })

  test('a project is renamed in its head, and the head says the new name', async () => {
    const { asked } = serve({
      ...inProject(),
      'PATCH /v1/projects/p1': ({ body }: Asked) => aProject('producer', body as Record<string, unknown>),
    })
    openApp('/projects/p1')
    await userEvent.click(await screen.findByRole('button', { name: /Change name, prefix/ }))
    await userEvent.clear(screen.getByLabelText('Name'))
    await userEvent.type(screen.getByLabelText('Name'), 'Shield Wing II')
    await userEvent.click(screen.getByRole('button', { name: 'Save' }))
    expect(await screen.findByRole('heading', { name: 'Shield Wing II' })).toBeVisible()
    expect(wrote(asked, 'PATCH /v1/projects/p1')[0]?.body).toMatchObject({ name: 'Shield Wing II', cue_prefix: 'SW' })
  })
})

describe('people', () => {
  const INVITATION = {
    id: 'i1',
    email: 'foley@sound.example',
    kind: 'contract',
    note: 'Six palette sounds first.',
    inviter: people.producer,
    created_at: '2026-11-20T10:00:00Z',
    expires_at: '2099-12-20T10:00:00Z',
    accepted_at: null,
  }
  const mail = (recipient: string, link: string, sent_at: string | null = null) => ({
    id: link,
    recipient,
    subject: 'An invitation',
    text: '',
    link,
    created_at: '2026-11-20T10:00:00Z',
    sent_at,
    failure: null,
  })

  test('a designer is invited by address, kind and note', async () => {
    const { asked, answers } = serve({ ...inProject(), 'POST /v1/projects/p1/invitations': answer(INVITATION, 201) })
    openApp('/projects/p1/people')
    await userEvent.type(await screen.findByLabelText('Mail address'), 'foley@sound.example')
    await userEvent.type(screen.getByLabelText(/Note/), 'Six palette sounds first.')
    answers['GET /v1/projects/p1/invitations'] = [INVITATION]
    await userEvent.click(screen.getByRole('button', { name: 'Send the invitation' }))
    const open = await screen.findByRole('list', { name: 'Open invitations' })
    expect(within(open).getByText('foley@sound.example')).toBeVisible()
    expect(wrote(asked, 'POST /v1/projects/p1/invitations')[0]?.body).toEqual({
      email: 'foley@sound.example',
      kind: 'contract',
      note: 'Six palette sounds first.',
    })
    expect(screen.getByLabelText('Mail address')).toHaveValue('')
  })

  test('a refused address keeps what was typed, with the reason below', async () => {
    const message = 'this designer is engaged on the project already'
    serve({
      ...inProject(),
      'POST /v1/projects/p1/invitations': refusal(409, 'already-engaged', message, {
        errors: [{ where: 'email', message }],
      }),
    })
    openApp('/projects/p1/people')
    await userEvent.type(await screen.findByLabelText('Mail address'), 'designer@sound.example')
    await userEvent.click(screen.getByRole('button', { name: 'Send the invitation' }))
    expect(await screen.findByText('This designer is engaged on the project already.')).toBeVisible()
    expect(screen.getByLabelText('Mail address')).toHaveValue('designer@sound.example')
  })

  test('without a mail server the newest unsent link is there to copy, and only a link of an invitation', async () => {
    serve({
      ...inProject(),
      'GET /v1/projects/p1/invitations': [INVITATION],
      'GET /v1/studios/s1/outbox': {
        can_send: false,
        mails: [
          mail('foley@sound.example', 'http://x/projects/p1'),
          mail('foley@sound.example', 'http://x/invitation/new'),
          mail('foley@sound.example', 'http://x/invitation/old'),
        ],
      },
    })
    const press = user()
    openApp('/projects/p1/people')
    expect(await screen.findByText(/No mail server is set/)).toBeVisible()
    await press.click(screen.getByRole('button', { name: 'Copy link for foley@sound.example' }))
    expect(copied).toEqual(['http://x/invitation/new'])
  })

  test('an invitation is revoked', async () => {
    const { asked, answers } = serve({
      ...inProject(),
      'GET /v1/projects/p1/invitations': [INVITATION],
      'DELETE /v1/projects/p1/invitations/i1': answer(null, 204),
    })
    openApp('/projects/p1/people')
    const button = await screen.findByRole('button', { name: /^Revoke the invitation of foley/ })
    answers['GET /v1/projects/p1/invitations'] = []
    await userEvent.click(button)
    await waitFor(() => expect(screen.queryByText('foley@sound.example')).toBeNull())
    expect(wrote(asked, 'DELETE /v1/projects/p1/invitations/i1')).toHaveLength(1)
  })

  test('an engagement is ended, and taken up again by Undo', async () => {
    let ended = false
    const { asked } = serve({
      ...inProject(),
      'GET /v1/projects/p1': () =>
        aProject('producer', {
          engagements: [
            {
              id: 'e1',
              designer: people.designer,
              kind: 'contract',
              created_at: '2026-11-02T10:00:00Z',
              ended_at: ended ? '2026-11-21T10:00:00Z' : null,
            },
          ],
        }),
      'PATCH /v1/projects/p1/engagements/e1': ({ body }: Asked) => {
        ended = (body as { ended: boolean }).ended
        return {}
      },
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: /^End/ }))
    expect(await screen.findByRole('button', { name: /^Take up again/ })).toBeVisible()
    await userEvent.click(screen.getByRole('button', { name: /Undo/ }))
    expect(await screen.findByRole('button', { name: /^End/ })).toBeVisible()
    expect(wrote(asked, 'PATCH /v1/projects/p1/engagements/e1').map(({ body }) => body)).toEqual([
      { ended: true },
      { ended: false },
    ])
  })

  test('a producer takes the last word over, with a reason that is kept', async () => {
    const { asked, answers } = serve({
      ...inProject(),
      'PUT /v1/projects/p1/decider': ({ body }: Asked) => {
        const change = body as { reason: string }
        answers['GET /v1/projects/p1/decider-history'] = [
          {
            person: people.producer,
            reason: change.reason,
            changer: people.producer,
            created_at: '2026-11-21T10:00:00Z',
          },
          {
            person: people.decider,
            reason: 'Knows the game',
            changer: people.producer,
            created_at: '2026-11-01T10:00:00Z',
          },
        ]
        return aProject('producer', { decider: people.producer })
      },
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: 'Take it over' }))
    await userEvent.type(screen.getByLabelText('Why; it is kept'), 'Away until Monday')
    await userEvent.click(screen.getByRole('button', { name: 'Give the last word' }))
    const had = await screen.findByRole('list', { name: 'Who had the last word' })
    await waitFor(() => expect(within(had).getAllByRole('listitem')).toHaveLength(2))
    expect(within(had).getAllByRole('listitem')[0]).toHaveTextContent('Producer took it over: Away until Monday.')
    expect(within(had).getAllByRole('listitem')[1]).toHaveTextContent(
      'Audio director named by Producer: Knows the game.',
    )
    expect(wrote(asked, 'PUT /v1/projects/p1/decider')[0]?.body).toEqual({
      person_id: 'x1',
      reason: 'Away until Monday',
    })
  })

  test('a reason must be given', async () => {
    const message = 'must have at least 1 character'
    serve({
      ...inProject(),
      'PUT /v1/projects/p1/decider': refusal(422, 'invalid', 'a field does not fit', {
        errors: [{ where: 'reason', message }],
      }),
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: 'Name another' }))
    await userEvent.click(screen.getByRole('button', { name: 'Give the last word' }))
    expect(await screen.findByText('Must have at least 1 character.')).toBeVisible()
  })

  test('a liaison is made; the approver stays one, and it is said why', async () => {
    const { asked } = serve({
      ...inProject(),
      'PUT /v1/projects/p1/liaisons/x4': aProject('producer', { liaisons: [people.decider, people.composer] }),
      'DELETE /v1/projects/p1/liaisons/x2': refusal(409, 'liaison-decides', 'this liaison is the project’s approver', {
        fix: 'name another approver first',
      }),
    })
    openApp('/projects/p1/people')
    await userEvent.click(await screen.findByRole('button', { name: 'Make liaison: Composer' }))
    expect(await screen.findByRole('button', { name: 'Remove as liaison: Composer' })).toBeVisible()
    expect(wrote(asked, 'PUT /v1/projects/p1/liaisons/x4')).toHaveLength(1)
    await userEvent.click(screen.getByRole('button', { name: 'Remove as liaison: Audio director' }))
    const alert = await screen.findByRole('alert')
    expect(alert).toHaveTextContent('This liaison is the project’s approver. Name another approver first.')
  })
})
