import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, beforeEach, expect, test, vi } from 'vitest'

import type { CueReview } from '@/verdicts/api'
import { HandContext } from '@/test/audioContext'
import { openApp } from '@/test/openApp'
import { aMe, anItem, aPreview, aReview, aServer, aTake, APPROVER, PROJECT, somePeaks } from '@/test/review'
import { refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('@/verdicts/MentionList')]))

const shield = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a', { number: 1 })])
const PEOPLE = [
  { id: 'comp', name: 'Composer' },
  { id: 'des', name: 'Sound designer' },
  { id: 'code', name: 'Coder' },
]
const aComment = (more: Partial<CueReview['comments'][number]> = {}): CueReview['comments'][number] => ({
  id: 'c1',
  take_id: 'a',
  reply_to_id: null,
  change_request_id: null,
  text: 'too long?',
  start_s: null,
  end_s: null,
  author: APPROVER,
  decides: true,
  created_at: '2026-11-20T10:00:00Z',
  resolved_at: null,
  mentions: [],
  acknowledgements: [],
  ...more,
})

let server: ReturnType<typeof aServer>
const posts = () => server.asked.filter(({ method }) => method === 'POST')
const serveComments = (...comments: CueReview['comments']) =>
  server.on('GET /v1/cues/shield/review', aReview(shield, { comments }))

beforeEach(() => {
  vi.stubGlobal('AudioContext', HandContext)
  server = aServer()
    .on('GET /v1/me', aMe())
    .on('GET /v1/review-queue', { items: [shield], next: null })
    .on('GET /v1/review-queue/count', { cues: 1, is_all: true })
    .on(`GET /v1/projects/${PROJECT}/change-requests`, { items: [], next: null })
    .on(`GET /v1/projects/${PROJECT}/overview`, { palette: [] })
    .on(`GET /v1/projects/${PROJECT}/judged-lately`, [])
    .on('GET /v1/sounds/a/preview', aPreview)
    .on('GET /v1/sounds/a/peaks.json', somePeaks)
    .on('GET /v1/takes/a/people', PEOPLE)
    .on('POST /v1/takes/a/comments', aComment())
  serveComments()
})

async function opened() {
  openApp(`/projects/${PROJECT}/review/shield`)
  await screen.findByRole('region', { name: 'Verdict' })
}

test('an @ offers people; arrows and Enter choose one, whose id is sent', { tags: ['slow'] }, async () => {
  await opened()
  await userEvent.keyboard('cask @co')
  const list = await screen.findByRole('listbox', { name: 'People to mention' })
  expect(within(list).getAllByRole('option')).toHaveLength(2)
  expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  await userEvent.keyboard('{ArrowDown}{ArrowUp}{ArrowDown}{Enter}')
  const field = screen.getByRole('textbox', { name: /^Comment/ })
  expect(field).toHaveValue('ask @Coder ')
  expect(posts()).toHaveLength(0)
  await userEvent.keyboard('if it clips{Enter}')
  await waitFor(() => expect(posts()).toHaveLength(1))
  expect(posts()[0]?.body).toMatchObject({ text: 'ask @Coder if it clips', mentions: ['code'] })
})

test('Escape closes the list and not the comment; what nobody is called offers nobody', async () => {
  await opened()
  await userEvent.keyboard('c@')
  await screen.findByRole('listbox', { name: 'People to mention' })
  await userEvent.keyboard('{Escape}')
  expect(screen.queryByRole('listbox', { name: 'People to mention' })).toBeNull()
  const field = screen.getByRole('textbox', { name: /^Comment/ })
  expect(field).toHaveValue('@')
  await userEvent.keyboard(' @zz')
  expect(screen.queryByRole('listbox', { name: 'People to mention' })).toBeNull()
})

test('who is mentioned and no longer may be is said, and the text stays', async () => {
  server.on('POST /v1/takes/a/comments', () => refusal(422, 'not-mentionable', 'Composer may not see this version.'))
  await opened()
  await userEvent.keyboard('c@Composer look{Enter}')
  expect(await screen.findByRole('alert')).toHaveTextContent('Composer may not see this version.')
  expect(screen.getByRole('textbox', { name: /^Comment/ })).toHaveValue('@Composer look')
})

test('who is mentioned says that they have seen it, and a resolved comment is opened again', async () => {
  const me = aMe().person
  const mentions = [{ person_id: me.id, name: me.name }]
  server
    .on('POST /v1/comments/c1/acknowledgement', aComment())
    .on('POST /v1/comments/c2/reopen', aComment({ id: 'c2' }))
  serveComments(
    aComment({ text: `@${me.name}, too long?`, mentions }),
    aComment({ id: 'c2', author: { id: 'comp', name: 'Composer' }, resolved_at: '2026-11-20T11:00:00Z' }),
  )
  await opened()
  expect(await screen.findByText(`@${me.name}`)).toHaveClass('strong')
  await userEvent.click(screen.getByRole('button', { name: `Seen: what ${APPROVER.name} said` }))
  await userEvent.click(screen.getByRole('button', { name: /^Comment .*by Composer/ }))
  await userEvent.click(screen.getByRole('button', { name: /^Reopen\s*what Composer said$/ }))
  await waitFor(() =>
    expect(posts().map(({ path }) => path)).toEqual(['/v1/comments/c1/acknowledgement', '/v1/comments/c2/reopen']),
  )
})

test('who has seen a comment stands below it', async () => {
  serveComments(
    aComment({
      acknowledgements: [
        { person: { id: 'des', name: 'Sound designer' }, created_at: '2026-11-20T11:00:00Z' },
        { person: { id: 'comp', name: 'Composer' }, created_at: '2026-11-20T12:00:00Z' },
      ],
    }),
  )
  await opened()
  expect(await screen.findByText('Seen by Sound designer, Composer')).toBeVisible()
})
