import { act, fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeEach, expect, test, vi } from 'vitest'

import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aPlaylistTake as take, LIVE, PLAYLIST } from '@/test/playlist'
import { inProject, people } from '@/test/project'
import { anItem, aPreview, aReview, aTake } from '@/test/review'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

import { chosenCues, NO_FILTER } from './choice'
import { dayAfter, endOfDay } from './days'
import { moved } from './order'

const AT = '2026-11-20T10:00:00Z'
const GONE = 'This link does not open anything any more.'

const link = (id: string, more: object = {}) => ({
  id,
  kind: 'cues',
  title: 'For the composer',
  state: 'open',
  sounds: 3,
  has_password: true,
  may_comment: true,
  has_beeps: true,
  expires_at: '2998-12-10T22:59:59Z',
  max_openings: 5,
  openings: 2,
  plays: 7,
  made_by: people.producer,
  created_at: AT,
  revoked_at: null,
  is_own: true,
  ...more,
})
const CUES = [
  { id: 'c1', label: 'SW-001', name: 'shield_hit', category: 'impact', state: 'locked' },
  { id: 'c2', label: 'SW-002', name: 'shield_down', category: 'impact', state: 'locked' },
  { id: 'c3', label: 'SW-003', name: 'door', category: 'doors', state: 'locked' },
  { id: 'c4', label: 'SW-004', name: 'gone', category: 'doors', state: 'cut' },
]
function open(path: string, more: object = {}, part: 'producer' | 'reviewer' | 'designer' = 'producer') {
  const { asked } = serve(
    inProject(part, {
      'GET /v1/projects/p1/sound-list': { revision: 1, next: null, cues: CUES },
      'GET /v1/projects/p1/guest-links': { items: [link('g1')], next: null },
      'GET /v1/projects/p1/playlists': [
        { id: 'l1', name: 'Combat', takes: 3, made_by: people.producer, created_at: AT },
      ],
      'GET /v1/playlists/l1': PLAYLIST,
      'GET /v1/playlists/l1/live': LIVE,
      'PUT /v1/playlists/l1/position': answer(null, 204),
      ...more,
    }),
  )
  openApp(path)
  return asked
}

const noViolations = async () => {
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id }) => id)).toEqual([])
}

beforeEach(() => {
  sessionStorage.clear()
  localStorage.clear()
})

test('a link is made of what a filter gives now, and its address is shown', { tags: ['slow'] }, async () => {
  const asked = open('/projects/p1/sharing', {
    'POST /v1/projects/p1/guest-links': answer({ link: link('g2'), url: 'https://x.test/listen/secret' }, 201),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'New guest link' }))
  const card = await screen.findByRole('region', { name: 'New guest link' })
  expect(await within(card).findByText(/^3 cues: shield_hit, shield_down, door\./)).toBeVisible()
  await userEvent.type(within(card).getByLabelText('Name contains'), 'shield')
  expect(within(card).getByText(/^2 cues: shield_hit, shield_down\. .*come later are not added/)).toBeVisible()
  fireEvent.change(within(card).getByLabelText('Title for guests'), { target: { value: 'For the publisher' } })
  fireEvent.change(within(card).getByLabelText('Password (optional)'), { target: { value: 'four unrelated words' } })
  await userEvent.click(within(card).getByLabelText(/quiet beep/))
  await userEvent.click(within(card).getByRole('button', { name: 'Make link' }))
  expect(await screen.findByDisplayValue('https://x.test/listen/secret')).toBeVisible()
  expect(wrote(asked, 'POST /v1/projects/p1/guest-links')[0]?.body).toMatchObject({
    kind: 'cues',
    title: 'For the publisher',
    cue_ids: ['c1', 'c2'],
    password: 'four unrelated words',
    may_comment: true,
    has_beeps: true,
    max_openings: null,
  })
  expect(JSON.stringify({ ...localStorage, ...sessionStorage })).not.toContain('unrelated')
  await noViolations()
})

test('who heard what stands under a link, and a link is revoked', { tags: ['slow'] }, async () => {
  const played = [{ place: 1, cue_name: 'laser', variation: 1, plays: 3, last_at: AT }]
  const asked = open('/projects/p1/sharing', {
    'GET /v1/guest-links/g1/visits': {
      items: [{ id: 'v1', guest_name: 'Ada', opened_at: AT, played }],
      next: null,
    },
    'POST /v1/guest-links/g1/revoke': link('g1', { state: 'revoked' }),
    'GET /v1/guest-links/g1/address': { url: 'https://x.test/listen/again' },
  })
  const row = await screen.findByRole('button', { name: /For the composer/, expanded: false })
  expect(screen.getByText(/3 sounds, password, comments, beeps, until .* at most 5 openings/)).toBeVisible()
  await userEvent.click(row)
  expect(await screen.findByText(/laser 3 times/)).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Show address' }))
  expect(await screen.findByDisplayValue('https://x.test/listen/again')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: /Revoke/ }))
  await waitFor(() => expect(wrote(asked, 'POST /v1/guest-links/g1/revoke')).toHaveLength(1))
})

test('a reviewer sees playlists and makes no links', async () => {
  open('/projects/p1/sharing', {}, 'reviewer')
  expect(await screen.findByRole('link', { name: 'Combat' })).toBeVisible()
  expect(screen.queryByRole('button', { name: 'New guest link' })).toBeNull()
  expect(screen.queryByRole('button', { name: 'New playlist' })).toBeNull()
})

test(
  'a playlist opens where one stopped; Alt and arrows, and buttons, put it in order',
  { tags: ['slow'] },
  async () => {
    const asked = open('/projects/p1/playlists/l1', {
      'PATCH /v1/playlists/l1': ({ body }: Asked) => {
        const { take_ids: order } = body as { take_ids: string[] }
        return answer({
          ...PLAYLIST,
          edition: 5,
          takes: order.map((id) => PLAYLIST.takes.find(({ take_id }) => take_id === id)),
        })
      },
    })
    const now = await screen.findByRole('region', { name: 'Now' })
    expect(now).toHaveTextContent('door')
    const names = () =>
      within(screen.getByRole('list', { name: '3 sounds in order' }))
        .getAllByRole('listitem')
        .map((row) => row.textContent?.match(/laser|door|steps/)?.[0])
    expect(names()).toEqual(['laser', 'door', 'steps'])
    screen.getByRole('button', { name: /^steps/ }).focus()
    await userEvent.keyboard('{Alt>}{ArrowUp}{/Alt}')
    await waitFor(() => expect(names()).toEqual(['laser', 'steps', 'door']))
    await userEvent.click(screen.getByRole('button', { name: 'Move laser down' }))
    await waitFor(() => expect(names()).toEqual(['steps', 'laser', 'door']))
    await waitFor(() => expect(wrote(asked, 'PATCH /v1/playlists/l1')).toHaveLength(2))
    expect(wrote(asked, 'PATCH /v1/playlists/l1').map(({ body }) => body)).toEqual([
      { edition: 4, take_ids: ['t1', 't3', 't2'] },
      { edition: 5, take_ids: ['t3', 't1', 't2'] },
    ])
    await noViolations()
  },
)

test('labels distinguish alternates in the list and in the player', { tags: ['slow'] }, async () => {
  const takes = [take('t1', 'door', { label: 'longer' }), take('t2', 'door', { label: 'wild' }), take('t3', 'steps')]
  open('/projects/p1/playlists/l1', { 'GET /v1/playlists/l1': { ...PLAYLIST, takes } })
  expect(await screen.findByRole('region', { name: 'Now' })).toHaveTextContent('door SW-001 wild')
  const rows = within(screen.getByRole('list', { name: '3 sounds in order' })).getAllByRole('button', {
    name: /version/,
  })
  expect(rows.map((row) => row.textContent)).toEqual([
    'door version 2 longer',
    'door version 2 wild',
    'steps version 2 ',
  ])
  await noViolations()
})

test('a refused order stands as it was, with the reason', async () => {
  open('/projects/p1/playlists/l1', {
    'PATCH /v1/playlists/l1': refusal(409, 'playlist-changed', 'another person changed this playlist'),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Move laser down' }))
  expect(await screen.findByText(/another person changed this playlist/i)).toBeVisible()
  await waitFor(() => {
    const [first] = within(screen.getByRole('list', { name: '3 sounds in order' })).getAllByRole('listitem')
    expect(first).toHaveTextContent('laser')
  })
})

test('a playlist says beforehand that a version cannot be approved yet', async () => {
  const door = aTake('t2')
  const item = anItem({ id: 'c-t2', name: 'door' }, [door])
  const asked = open('/projects/p1/playlists/l1', {
    'GET /v1/playlists/l1': { ...PLAYLIST, takes: [take('t2', 'door', { may_approve: true })] },
    'GET /v1/cues/c-t2/review': aReview(item, {
      checklist: {
        blockers: 'notes',
        items: [],
        checks: [],
        blocked: [{ take_id: 't2', why: '1 comment is not resolved' }],
      },
    }),
    'POST /v1/takes/t2/verdict': {},
  })
  expect(await screen.findByText('Not to be approved yet: 1 comment is not resolved.')).toBeVisible()
  expect(screen.getByRole('button', { name: /^Approve/ })).toBeDisabled()
  expect(screen.getByRole('button', { name: /^Request a change/ })).toBeEnabled()
  await userEvent.keyboard('a')
  expect(wrote(asked, 'POST /v1/takes/t2/verdict')).toHaveLength(0)
})

test('a designer hears a playlist with a sound of theirs, and changes, decides and leads nothing', async () => {
  const heard = { ...PLAYLIST, may_share: false, may_join: false }
  const asked = open('/projects/p1/playlists/l1', { 'GET /v1/playlists/l1': heard }, 'designer')
  expect(await screen.findByRole('button', { name: 'Play' })).toBeEnabled()
  await userEvent.keyboard('j')
  await waitFor(() => expect(screen.getByRole('region', { name: 'Now' })).toHaveTextContent('steps'))
  screen.getByRole('button', { name: /^steps/ }).focus()
  await userEvent.keyboard('{Alt>}{ArrowUp}{/Alt}')
  await userEvent.keyboard('ar')
  expect(screen.queryByRole('region', { name: 'Session' })).toBeNull()
  expect(screen.queryByRole('button', { name: /^(Approve|Request|Move|Take|Remove)/ })).toBeNull()
  expect(within(screen.getByRole('main')).queryByRole('link', { name: /Review|guests/ })).toBeNull()
  expect(asked.filter(({ path }) => path.includes('/live'))).toEqual([])
  expect(wrote(asked, 'PATCH /v1/playlists/l1')).toEqual([])
  await noViolations()
})

test('in a session control is taken and handed over', async () => {
  const both = [people.producer, people.composer]
  const asked = open('/projects/p1/playlists/l1', {
    'PUT /v1/playlists/l1/live/presence': { ...LIVE, present: both },
    'PUT /v1/playlists/l1/live/keys': ({ body }: Asked) =>
      (body as { act: string }).act === 'take'
        ? answer({ ...LIVE, sequence: 2, holder: people.producer, is_holder: true, present: both })
        : answer({ ...LIVE, sequence: 3, holder: people.composer, present: both }),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Start session' }))
  await userEvent.click(await screen.findByRole('button', { name: 'Take control' }))
  expect(await screen.findByText(/You have control/)).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: /Hand over control to Composer/ }))
  expect(await screen.findByText('Composer has control.')).toBeVisible()
  expect(wrote(asked, 'PUT /v1/playlists/l1/live/keys').map(({ body }) => body)).toEqual([
    { act: 'take', page_id: expect.any(String) as string },
    { act: 'give', person_id: 'x4', page_id: expect.any(String) as string },
  ])
  expect(screen.getByRole('button', { name: 'Play' })).toBeDisabled()
})

test('who starts a session holds its keys, and the next key plays', async () => {
  const asked = open('/projects/p1/playlists/l1', {
    'PUT /v1/playlists/l1/live/presence': {
      ...LIVE,
      holder: people.producer,
      is_holder: true,
      present: [people.producer],
    },
    'PUT /v1/playlists/l1/live/playhead': {
      ...LIVE,
      holder: people.producer,
      is_holder: true,
      present: [people.producer],
    },
    'GET /v1/sounds/p-t2/preview': aPreview,
  })
  vi.stubGlobal('AudioContext', HandContext)
  await userEvent.click(await screen.findByRole('button', { name: 'Start session' }))
  expect(await screen.findByText(/You have control/)).toBeVisible()
  expect(screen.getByRole('button', { name: 'Play' })).toHaveFocus()
  await userEvent.keyboard(' ')
  expect(await screen.findByRole('button', { name: 'Pause' })).toBeVisible()
  expect(screen.getByRole('button', { name: 'Leave' })).toBeVisible()
  await waitFor(() =>
    expect(wrote(asked, 'PUT /v1/playlists/l1/live/playhead')[0]?.body).toMatchObject({ is_playing: true }),
  )
})

test('a second tab of who has control is silent, says so, and takes them over', { tags: ['slow'] }, async () => {
  const held = { ...LIVE, holder: people.producer, present: [people.producer] }
  const playing = { take_id: 't3', position_s: 0.2 }
  const asked = open('/projects/p1/playlists/l1', {
    'GET /v1/playlists/l1/live': { ...held, ...playing, is_elsewhere: true },
    'PUT /v1/playlists/l1/live/presence': { ...held, ...playing, is_elsewhere: true },
    'PUT /v1/playlists/l1/live/keys': { ...held, ...playing, sequence: 2, is_holder: true },
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Join session' }))
  expect(await screen.findByText(/You have control in another tab/)).toBeVisible()
  await noViolations()
  await new Promise((done) => setTimeout(done, 1_000)) // four looks at what all hear
  expect(screen.getByRole('region', { name: 'Now' })).toHaveTextContent('door')
  expect(screen.getByRole('button', { name: 'Play' })).toBeDisabled()
  expect(screen.getByText('Your other tab plays.')).toBeVisible()
  await userEvent.click(screen.getByRole('button', { name: 'Take control here' }))
  expect(await screen.findByText(/You have control: all hear what you play/)).toBeVisible()
  const [taken] = wrote(asked, 'PUT /v1/playlists/l1/live/keys')
  const [reported] = wrote(asked, 'PUT /v1/playlists/l1/live/presence')
  expect(taken?.body).toEqual({ act: 'take', page_id: (reported?.body as { page_id: string }).page_id })
  // It goes on where all are, before it leads.
  await waitFor(() => expect(screen.getByRole('region', { name: 'Now' })).toHaveTextContent('steps'))
})

test('a second tab of a listener goes on here', async () => {
  const heard = { ...LIVE, holder: people.composer, present: [people.producer, people.composer] }
  const asked = open('/projects/p1/playlists/l1', {
    'PUT /v1/playlists/l1/live/presence': ({ body }: Asked) =>
      answer({ ...heard, is_elsewhere: !(body as { takes_over?: boolean }).takes_over }),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Start session' }))
  await userEvent.click(await screen.findByRole('button', { name: 'Listen here' }))
  expect(await screen.findByText('Composer has control.')).toBeVisible()
  expect(wrote(asked, 'PUT /v1/playlists/l1/live/presence').at(-1)?.body).toMatchObject({ takes_over: true })
})

const ROOM = {
  title: 'For the composer',
  guest_name: 'Ada',
  may_comment: true,
  has_beeps: false,
  sounds: [
    { place: 1, name: 'laser', variation: null, duration_s: 0.8, thumb: null, is_ready: true },
    { place: 2, name: 'steps', variation: 2, duration_s: 0.4, thumb: null, is_ready: false },
  ],
}

function openLink(more: object) {
  const { asked } = serve({ 'GET /v1/session': refusal(401, 'not-signed-in', 'sign in'), ...more })
  openApp('/listen/secret')
  return asked
}

test('a guest types a name and the password, hears the sounds and comments', { tags: ['slow'] }, async () => {
  const answers = [
    refusal(403, 'guest-password-wrong', 'this is not the link’s password'),
    answer({ visit: 'visit-secret', room: ROOM }, 201),
  ]
  const asked = openLink({
    'GET /v1/guest-access/secret': { needs_password: true },
    'POST /v1/guest-access/secret/visits': () => answers.shift(),
    'GET /v1/guest-visits/visit-secret': ROOM,
    'POST /v1/guest-visits/visit-secret/sounds/1/comments': answer(
      { text: 'Too bright', start_s: null, end_s: null, created_at: AT },
      201,
    ),
  })
  fireEvent.change(await screen.findByLabelText('Your name'), { target: { value: 'Ada' } })
  fireEvent.change(screen.getByLabelText('Password of the link'), { target: { value: 'wrong' } })
  await userEvent.click(screen.getByRole('button', { name: 'Open' }))
  expect(await screen.findByText(/not the link’s password/)).toBeVisible()
  expect(screen.getByLabelText('Your name')).toHaveValue('Ada')
  await userEvent.click(screen.getByRole('button', { name: 'Open' }))
  expect(await screen.findByRole('heading', { name: 'For the composer' })).toBeVisible()
  const rows = within(screen.getByRole('list', { name: 'Sounds' })).getAllByRole('listitem')
  expect(rows.map((row) => row.textContent)).toEqual(['laser0.80 s', 'steps 20.40 s'])
  await userEvent.type(screen.getByLabelText('Comment on laser'), 'Too bright')
  await userEvent.click(screen.getByRole('button', { name: 'Send comment' }))
  expect(await screen.findByText('sent')).toBeVisible()
  expect(screen.getByLabelText('Comment on laser')).toHaveValue('')
  expect(wrote(asked, 'POST /v1/guest-access/secret/visits')[1]?.body).toEqual({ guest_name: 'Ada', password: 'wrong' })
  expect(wrote(asked, 'POST /v1/guest-visits/visit-secret/sounds/1/comments')[0]?.body).toMatchObject({
    text: 'Too bright',
    start_s: null,
  })
  await noViolations()
})

test('one tap plays the whole list: the next sound that is ready follows, each on record before it is sent', async () => {
  let context: HandContext | undefined
  vi.stubGlobal(
    'AudioContext',
    class extends HandContext {
      constructor() {
        super()
        // eslint-disable-next-line @typescript-eslint/no-this-alias -- the page makes it
        context = this
      }
    },
  )
  const [laser, steps] = ROOM.sounds
  sessionStorage.setItem('soundlist-visit:secret', 'visit-secret')
  const asked = openLink({
    'GET /v1/guest-visits/visit-secret': { ...ROOM, sounds: [laser, steps, { ...laser, place: 3, name: 'door' }] },
    'POST /v1/guest-visits/visit-secret/sounds/1/plays': answer(null, 204),
    'POST /v1/guest-visits/visit-secret/sounds/3/plays': answer(null, 204),
    'GET /v1/guest-visits/visit-secret/sounds/1/preview': aPreview,
    'GET /v1/guest-visits/visit-secret/sounds/3/preview': aPreview,
  })
  const now = async (name: string) =>
    expect(within(await screen.findByRole('region', { name: 'Now' })).getByText(name)).toBeVisible()
  await now('laser')
  await userEvent.click(screen.getByRole('button', { name: 'Play' }))
  await waitFor(() => expect(context?.started).toHaveLength(1))
  if (context) context.currentTime += 1
  act(() => context?.started[0]?.end())
  await waitFor(() => expect(context?.started).toHaveLength(2))
  await now('door')
  expect(wrote(asked, 'POST /v1/guest-visits/visit-secret/sounds/3/plays')).toHaveLength(1)
  if (context) context.currentTime += 1
  act(() => context?.started[1]?.end())
  expect(await screen.findByRole('button', { name: 'Play' })).toBeVisible()
  sessionStorage.clear()
})

test('a link that opens nothing says so and no more', async () => {
  openLink({ 'GET /v1/guest-access/secret': refusal(404, 'guest-link-not-found', GONE, { fix: 'ask for a new one' }) })
  expect(await screen.findByRole('heading', { name: GONE })).toBeVisible()
  expect(screen.queryByLabelText('Your name')).toBeNull()
})

test('a reload goes on with the visit, and a visit that is over says so', async () => {
  sessionStorage.setItem('soundlist-visit:secret', 'old')
  const asked = openLink({
    'GET /v1/guest-visits/old': refusal(404, 'guest-visit-over', GONE),
    'GET /v1/guest-access/secret': { needs_password: false },
  })
  expect(await screen.findByRole('heading', { name: GONE })).toBeVisible()
  expect(wrote(asked, 'POST /v1/guest-access/secret/visits')).toHaveLength(0)
  await userEvent.click(screen.getByRole('button', { name: 'Open the link again' }))
  expect(await screen.findByLabelText('Your name')).toBeVisible()
})

test('filters, orders and days', () => {
  expect(chosenCues(CUES, { ...NO_FILTER, category: 'doors' }).map(({ id }) => id)).toEqual(['c3', 'c4'])
  expect(chosenCues(CUES, { ...NO_FILTER, text: ' sw-002 ' }).map(({ id }) => id)).toEqual(['c2'])
  expect(chosenCues(CUES, { text: 'door', category: 'doors', cueId: 'c1' }).map(({ id }) => id)).toEqual(['c1'])
  expect(moved(['a', 'b', 'c'], 'a', 1)).toEqual(['b', 'a', 'c'])
  expect(moved(['a', 'b', 'c'], 'a', -3)).toEqual(['a', 'b', 'c'])
  expect(moved(['a', 'b', 'c'], 'a', 9)).toEqual(['b', 'c', 'a'])
  expect(moved(['a'], 'x', 0)).toEqual(['a'])
  expect(dayAfter(new Date(2026, 11, 25), 14)).toBe('2027-01-08')
  expect(new Date(endOfDay('2026-12-10')).getDate()).toBe(10)
})
