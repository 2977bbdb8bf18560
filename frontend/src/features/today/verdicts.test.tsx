import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aDraft, aMe, aTake, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'
import {
  alternates,
  day,
  DRAFTS,
  open,
  opened,
  question,
  queueIs,
  server,
  serveTodayPage,
  single,
  TODAY,
} from '@/test/todayPage'

beforeAll(() => import('./TodayPage'))
serveTodayPage()

describe('a verdict', () => {
  test('shows at once, before the server answered, and says as what the take was seen', async () => {
    let letGo = () => undefined as void
    const reply = new Promise<object>((resolve) => {
      letGo = () => resolve({})
    })
    server.on('POST /v1/takes/b/verdict', () => reply)
    await opened()
    await userEvent.keyboard('b')
    await userEvent.keyboard('a')
    expect(await screen.findByRole('heading', { name: 'Review version 2 of suit_hit' })).toBeVisible()
    expect(screen.getByRole('status')).toHaveTextContent('shield_hit B approved.')
    queueIs(single)
    letGo()
    await waitFor(() =>
      expect(server.of('POST /v1/takes/b/verdict')[0]?.body).toMatchObject({
        kind: 'approve',
        seen_state: 'conforming',
      }),
    )
  })

  test('of what was not heard is not given by the key, which plays it, but by the button that says so', async () => {
    queueIs({ ...alternates, takes: alternates.takes.map((take) => ({ ...take, is_heard: false })) }, single)
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    const card = screen.getByRole('region', { name: /Pick one of two/ })
    expect(card).toHaveTextContent('You have not heard A yet. Approve a plays it first.')
    await userEvent.keyboard('a')
    expect(await within(card).findByRole('button', { name: /Pause/ })).toBeVisible()
    expect(server.of('POST /v1/takes/a/verdict')).toEqual([])
    await userEvent.click(within(card).getByRole('button', { name: 'Approve without listening' }))
    await waitFor(() =>
      expect(server.of('POST /v1/takes/a/verdict')[0]?.body).toMatchObject({ kind: 'approve', heard: false }),
    )
  })

  test('u takes it back', async () => {
    server.on('POST /v1/takes/a/verdict', {}).on('DELETE /v1/takes/a/verdict', {})
    await opened()
    queueIs(single)
    await userEvent.keyboard('a')
    await screen.findByRole('heading', { name: 'Review version 2 of suit_hit' })
    queueIs(alternates, single)
    await userEvent.keyboard('u')
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
    expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1)
  })

  test('what is refused comes back with its reason, and no toast says otherwise', async () => {
    server.on('POST /v1/takes/a/verdict', () =>
      refusal(409, 'stale-view', 'Since you looked, this version was set aside; nothing was changed.', {
        fix: 'Load the page again.',
      }),
    )
    await opened()
    await userEvent.keyboard('a')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A is not approved. Since you looked, this version was set aside; nothing was changed. Load the page again.',
    )
    expect(await screen.findByRole('heading', { name: 'Pick one of two for shield_hit' })).toBeVisible()
    expect(screen.getByRole('status')).toBeEmptyDOMElement()
  })

  test('an undo that comes too late is said', async () => {
    server
      .on('POST /v1/takes/a/verdict', {})
      .on('DELETE /v1/takes/a/verdict', () => refusal(409, 'too-late-to-undo', 'The minute is over.'))
    await opened()
    queueIs(single)
    await userEvent.keyboard('a')
    await userEvent.click(await screen.findByRole('button', { name: 'Undo' }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A approved. It stays so. The minute is over.',
    )
  })

  test('those who advise are not offered it', async () => {
    server.on('GET /v1/me', aMe({ is_approver: false }))
    open()
    expect(await screen.findByText('The approver decides. You can comment.')).toBeInTheDocument()
    expect(screen.queryByRole('button', { name: /^Approve / })).toBeNull()
    await userEvent.keyboard('a')
    expect(server.asked.filter(({ method }) => method === 'POST')).toEqual([])
  })
})

describe('a change', () => {
  test('is noted by r, a digit, a line and Enter, letters typed at once included', async () => {
    server.on('POST /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('r13 dB less, at bass{Enter}')
    await waitFor(() => expect(server.of('POST /v1/takes/a/verdict')).toHaveLength(1))
    expect(server.of('POST /v1/takes/a/verdict')[0]?.body).toMatchObject({
      kind: 'request_change',
      note: 'Too loud. 3 dB less, at bass',
    })
    await waitFor(() => expect(screen.queryByRole('form')).toBeNull())
  })

  test('says what is missing when nothing was said', async () => {
    await opened()
    await userEvent.keyboard('r{Enter}')
    expect(screen.getByRole('alert')).toHaveTextContent('Choose a reason or write what to change.')
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByRole('form')).toBeNull()
  })

  test('keeps what was typed when it is refused', async () => {
    server.on('POST /v1/takes/a/verdict', () => refusal(409, 'cue-is-cut', 'The cue is cut.'))
    await opened()
    await userEvent.keyboard('rmore body{Enter}')
    expect(await screen.findByRole('alert')).toHaveTextContent('The cue is cut.')
    expect(screen.getByRole('textbox', { name: 'What to change in shield_hit A' })).toHaveValue('more body')
  })

  test('drafts go out together, after saying which rounds they count', async () => {
    const drafts = [aDraft(aTake('a'), alternates.cue, 'Too loud.'), aDraft(aTake('s'), single.cue, 'More body.')]
    server
      .on(`GET ${DRAFTS}`, { items: drafts, next: null })
      .on(`POST /v1/projects/${PROJECT}/feedback`, { change_requests: drafts, rounds: [], held_back: [] })
    await opened()
    const card = await screen.findByRole('region', { name: 'Changes to send' })
    await userEvent.click(within(card).getByRole('button', { name: '2 changes to send' }))
    expect(within(card).getByRole('textbox')).toHaveFocus()
    expect(card).toHaveTextContent('This counts as one round each for shield_hit and suit_hit. You can’t undo sending.')
    expect(server.of(`POST /v1/projects/${PROJECT}/feedback`)).toEqual([])
    await userEvent.type(within(card).getByRole('textbox'), 'Good direction')
    await userEvent.click(within(card).getByRole('button', { name: 'Send 2 changes to the designer' }))
    await waitFor(() =>
      expect(server.of(`POST /v1/projects/${PROJECT}/feedback`)[0]?.body).toEqual({ note: 'Good direction' }),
    )
    expect(screen.getByRole('status')).toHaveTextContent('2 changes sent.')
  })

  test('a draft can be dropped, and why it could not is said', async () => {
    const draft = aDraft(aTake('a'), alternates.cue, 'Too loud.')
    server
      .on(`GET ${DRAFTS}`, { items: [draft], next: null })
      .on('DELETE /v1/change-requests/draft-a', () => refusal(409, 'already-sent', 'It was sent meanwhile.'))
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: 'Delete draft for shield_hit' }))
    expect(await screen.findByRole('alert')).toHaveTextContent('It was sent meanwhile.')
  })
})

describe('a question', () => {
  const answering = async () => {
    server.on(`GET ${TODAY}`, day({ questions: [question] }))
    await opened()
    await userEvent.click(await screen.findByRole('button', { name: /coolant_splash/ }))
    await userEvent.keyboard('A spanner, into a tank{Enter}')
  }

  test('is answered in place', async () => {
    server.on('POST /v1/questions/question-1/answer', {})
    await answering()
    await waitFor(() =>
      expect(server.of('POST /v1/questions/question-1/answer')[0]?.body).toEqual({
        text: 'A spanner, into a tank',
        joins: true,
      }),
    )
    expect(await screen.findByText('Answered. It was added to the description of coolant_splash.')).toBeVisible()
  })

  test('keeps the answer when it is refused', async () => {
    server.on('POST /v1/questions/question-1/answer', () =>
      refusal(409, 'question-answered', 'It was answered already.'),
    )
    await answering()
    expect(await screen.findByRole('alert')).toHaveTextContent('It was answered already.')
    expect(screen.getByRole('textbox', { name: 'Answer for coolant_splash' })).toHaveValue('A spanner, into a tank')
  })
})
