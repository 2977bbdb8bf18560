import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, expect, test } from 'vitest'

import { answer, type Asked } from '@/test/server'
import { anItem, aReview, aTake, PROJECT } from '@/test/review'
import { opened, queueIs, server, serveReview, serveReviewPage, shield, walk } from '@/test/reviewPage'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

const unheardWalk = { ...walk, takes: walk.takes.map((take) => ({ ...take, is_heard: false })) }
const line = (name: RegExp) => within(screen.getByRole('complementary', { name: 'Queue' })).getByRole('link', { name })

test('a cue with a version that was not heard is marked, and a key opens it', async () => {
  const between = anItem({ id: 'between', name: 'between' }, [aTake('c')])
  queueIs(shield, between, unheardWalk)
  serveReview(aReview(unheardWalk))
  const app = await opened()
  expect(line(/foot_deck_walk/)).toHaveTextContent('not heard')
  expect(line(/shield_hit/)).not.toHaveTextContent('not heard')
  await userEvent.keyboard('{Shift>}j{/Shift}')
  await waitFor(() => expect(app.at()).toBe(`/projects/${PROJECT}/review/walk`))
  expect(await screen.findByRole('radiogroup', { name: 'Variations' })).toHaveTextContent('not heard')
  await userEvent.keyboard('{Shift>}j{/Shift}')
  expect(await screen.findByText('You have heard every other version that waits.')).toBeVisible()
})

test('one far down in a long queue is asked for', { tags: ['slow'] }, async () => {
  server
    .on('GET /v1/review-queue', ({ query }: Asked) => ({
      items: query.get('unheard') ? [unheardWalk] : [shield],
      next: query.get('unheard') ? null : 'more',
    }))
    .on('GET /v1/review-queue/count', { cues: 99, is_all: false })
  const app = await opened()
  await userEvent.keyboard('{Shift>}j{/Shift}')
  await waitFor(() => expect(app.at()).toBe(`/projects/${PROJECT}/review/walk`))
})

test('the filter leaves what was not heard, stands in the address and is asked of the server', async () => {
  queueIs(unheardWalk)
  const app = await opened('?heard=no')
  expect(app.search()).toEqual({ heard: 'no' })
  expect(server.of('GET /v1/review-queue')[0]?.query.get('unheard')).toBe('true')
  await userEvent.keyboard('f')
  expect(await screen.findByLabelText('Heard')).toHaveValue('no')
})

test('what is played for long enough is reported, and its mark goes', { tags: ['slow'] }, async () => {
  const short = anItem({ id: 'shield', name: 'shield_hit' }, [aTake('a', { is_heard: false })])
  queueIs(short)
  serveReview(aReview(short))
  server.on(`POST /v1/projects/${PROJECT}/heard-takes`, answer(null, 204))
  await opened()
  expect(line(/shield_hit/)).toHaveTextContent('not heard')
  await userEvent.keyboard(' ')
  await waitFor(() => expect(line(/shield_hit/)).not.toHaveTextContent('not heard'))
  await waitFor(
    () => expect(server.of(`POST /v1/projects/${PROJECT}/heard-takes`)[0]?.body).toEqual({ take_ids: ['a'] }),
    {
      timeout: 10_000,
    },
  )
})
