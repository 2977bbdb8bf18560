import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { aMe } from '@/test/review'
import { refusal } from '@/test/server'
import { aFix, aVersion, DESIGNER } from '@/test/take'
import { card, lastContext, lastStarted, opened, server, serveTakePage } from '@/test/takePage'

beforeAll(() => import('./TakePage'))
serveTakePage()

describe('the fix', () => {
  test('is seen before and after, with what changes, and used by its designer in one press', async () => {
    const user = userEvent.setup()
    server.on('POST /v1/takes/t1/fix/use', aVersion({ id: 't2', number: 2, state: 'received', fix_of_id: 't1' }))
    await opened()
    const fix = await card('Fix')
    expect(await within(fix).findByRole('slider', { name: 'Position in airlock_cycle, fixed' })).toBeInTheDocument()
    const changes = within(fix).getByLabelText('What changes')
    expect(changes).toHaveTextContent('Sample peak0.0 dBFS →becomes −1.6 dBFS')
    expect(changes).toHaveTextContent('Length0.80 s →becomes 0.40 s')
    expect(fix).toHaveTextContent('It becomes version 2; version 1 is kept. No round is counted.')
    await user.click(within(fix).getByRole('button', { name: 'Start' }))
    expect(within(fix).getByText('The start, 0.000–0.500 s')).toBeInTheDocument()
    await user.keyboard('t')
    expect(
      await screen.findByText('airlock_cycle version 2 is the fixed copy. It is being checked.'),
    ).toBeInTheDocument()
    expect(server.of('POST /v1/takes/t1/fix/use')).toHaveLength(1)
  })

  test('b hears the other one at the same place in the sound', async () => {
    const user = userEvent.setup()
    await opened()
    const fix = await card('Fix')
    await within(fix).findByRole('button', { name: /^Play fixed/ })
    await user.click(await screen.findByRole('button', { name: /^Play(?! (original|fixed))/ }))
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.8))
    const context = lastContext()
    if (context) context.currentTime = 0.6
    await user.keyboard('b')
    // 0.4 s were cut from the start: 0.6 s of the one are 0.2 s of the other.
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.4))
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.2))
    if (context) context.currentTime = 0.62 // once it has faded in
    await user.keyboard('b')
    await waitFor(() => expect(lastStarted()?.buffer.duration).toBe(0.8))
    await waitFor(() => expect(lastStarted()?.fromS).toBeCloseTo(0.62))
  })

  test('is made when its designer asks, and shown once it is made', async () => {
    const user = userEvent.setup()
    let state: 'offered' | 'making' | 'made' = 'offered'
    server
      .on('GET /v1/takes/t1/fix', () => aFix({ state, says: 'Trims 407.0 ms from the start.' }))
      .on('POST /v1/takes/t1/fix', () => {
        state = 'making'
        return aFix({ state })
      })
    await opened()
    const fix = await card('Fix')
    expect(fix).toHaveTextContent('Auto-fix: trims 407.0 ms from the start.')
    await user.click(within(fix).getByRole('button', { name: /^Make auto-fix/ }))
    expect(await within(fix).findByText(/Making the fixed copy/)).toBeInTheDocument()
    state = 'made'
    expect(await within(fix).findByRole('button', { name: /^Use auto-fix/ })).toBeInTheDocument()
  })

  test('the approver sees that it is offered, and cannot use it', async () => {
    server.on('GET /v1/me', aMe())
    const user = userEvent.setup()
    await opened()
    const fix = await card('Fix')
    expect(fix).toHaveTextContent('The designer decides whether to use it.')
    expect(within(fix).queryByRole('button', { name: /^Use auto-fix/ })).not.toBeInTheDocument()
    await user.keyboard('t')
    expect(server.asked.some(({ method }) => method === 'POST')).toBe(false)
  })

  test('a refusal stays where it happened', async () => {
    const user = userEvent.setup()
    server.on(
      'POST /v1/takes/t1/fix/use',
      refusal(409, 'nothing-to-fix', 'a change_requested version is decided upon', { fix: 'send your own version' }),
    )
    await opened()
    await user.click(await screen.findByRole('button', { name: /^Use auto-fix/ }))
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'A change_requested version is decided upon. Send your own version.',
    )
  })

  test('our own fault can be tried again', async () => {
    server.on('GET /v1/takes/t1/fix', aFix({ state: 'refused', says: 'Our mender failed.', is_our_fault: true }))
    await opened()
    expect(await screen.findByRole('button', { name: /^Make auto-fix/ })).toBeInTheDocument()
    expect(screen.getByText('Our mender failed.')).toBeInTheDocument()
  })

  test('both versions lead to each other, with who agreed', async () => {
    server.on('GET /v1/takes/t1/fix', aFix({ state: 'used', new_take_id: 't2', used_by: DESIGNER }))
    await opened()
    const link = await screen.findByRole('link', { name: 'Version 2' })
    expect(link).toHaveAttribute('href', '/takes/t2')
    expect(link.parentElement).toHaveTextContent('Version 2 is its fix, with the consent of Sound designer.')
  })

  test('a fix says what it was made of', async () => {
    const { repairs } = aFix()
    server.on(
      'GET /v1/takes/t1/fix',
      aFix({
        state: 'none',
        fixed_from: { take_id: 't0', number: 1, repairs, used_by: DESIGNER, used_at: '2026-11-20T10:00:00Z' },
      }),
    )
    await opened()
    expect(await screen.findByRole('link', { name: 'version 1' })).toHaveAttribute('href', '/takes/t0')
    expect(screen.getByText(/level lowered by 1\.62 dB\.$/)).toBeInTheDocument()
  })
})
