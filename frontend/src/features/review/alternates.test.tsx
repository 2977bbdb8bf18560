import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { beforeAll, describe, expect, test } from 'vitest'

import { comparedBlind } from '@/verdicts/comparedBlind'
import { anItem, aReview, aTake } from '@/test/review'
import { opened, queueIs, server, serveReview, serveReviewPage, shield, walk } from '@/test/reviewPage'
import { refusal } from '@/test/server'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

const alternate = (letter: string) =>
  within(screen.getByRole('radiogroup', { name: 'Alternates' })).getByRole('radio', { name: new RegExp(`^${letter}`) })

/** Open More and press one of its lines. */
const fromMore = async (line: string | RegExp, role = 'menuitem') => {
  await userEvent.click(within(screen.getByRole('main')).getByRole('button', { name: /^More/ }))
  await userEvent.click(await screen.findByRole(role, { name: line }))
}

describe('alternates', () => {
  test('2 takes the second in the hand, a approves it, and the next cue stands there', async () => {
    server.on('POST /v1/takes/b/verdict', {})
    await opened()
    await userEvent.keyboard('2')
    expect(alternate('B')).toHaveAttribute('aria-checked', 'true')
    queueIs(walk)
    await userEvent.keyboard('a')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    expect(screen.getByText('shield_hit B approved.')).toBeVisible()
    expect(server.of('POST /v1/takes/b/verdict')[0]?.body).toMatchObject({ kind: 'approve', seen_state: 'conforming' })
  })

  test('undo leads back to it', async () => {
    server.on('POST /v1/takes/a/verdict', {}).on('DELETE /v1/takes/a/verdict', {})
    await opened()
    await userEvent.keyboard('a')
    await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })
    await userEvent.keyboard('u')
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
    expect(server.of('DELETE /v1/takes/a/verdict')).toHaveLength(1)
  })

  test('a refusal leads back to it and is said there', async () => {
    server.on('POST /v1/takes/a/verdict', () => refusal(409, 'stale-view', 'It was set aside meanwhile.'))
    await opened()
    await userEvent.keyboard('a')
    expect(await screen.findByRole('alert')).toHaveTextContent(
      'shield_hit A is not approved. It was set aside meanwhile.',
    )
    expect(screen.getByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('heard blind, what tells them apart is hidden until d or a pick', async () => {
    await opened()
    expect(screen.getByRole('button', { name: /True peak −0.60 dBTP/ })).toBeInTheDocument()
    await userEvent.keyboard('d')
    expect(screen.queryByRole('button', { name: /True peak/ })).toBeNull()
    expect(alternate('A')).not.toHaveTextContent('heard')
    await userEvent.keyboard('.')
    expect(await screen.findByRole('menuitem', { name: 'Prefer A, as a comment' })).toBeVisible()
    expect(screen.queryByRole('menuitem', { name: /^Version/ })).toBeNull()
    await userEvent.keyboard('{Escape}')
    expect(comparedBlind()).toBe('shield')
    await userEvent.keyboard('d')
    expect(alternate('A')).toHaveTextContent('heard')
    expect(comparedBlind()).toBeUndefined()
  })

  test('levels are matched without a true peak over −1 dBTP, and m lets each be heard as delivered', async () => {
    const takes = [
      aTake('a', { alternate: 1, number: 1, loudness_lufs: -16, true_peak_dbtp: -3 }),
      aTake('b', { alternate: 2, number: 2, loudness_lufs: -20, true_peak_dbtp: -2 }),
    ]
    serveReview(aReview(anItem({ id: 'shield', name: 'shield_hit' }, takes)))
    await opened()
    expect(screen.getByText('matched: A −3.0 dB, B +1.0 dB')).toBeVisible()
    await userEvent.keyboard('m')
    expect(screen.queryByText(/^matched:/)).toBeNull()
    await userEvent.keyboard('.')
    expect(await screen.findByRole('menuitemcheckbox', { name: 'Match levels' })).not.toBeChecked()
  })

  test('a key chooses how it is heard, which is said and stays over cues until full range is chosen', async () => {
    await opened()
    fireEvent.keyDown(window, { key: '#', code: 'Digit3', shiftKey: true })
    expect(await screen.findByText(/Heard as: phone/)).toBeVisible()
    await userEvent.keyboard('j')
    expect(await screen.findByRole('heading', { name: 'foot_deck_walk', level: 1 })).toBeVisible()
    expect(localStorage.getItem('soundlist-heard-as')).toBe('phone')
    await fromMore('Heard as: phone')
    expect(await screen.findByRole('menuitemradio', { name: /^Phone.*mono, 700 Hz to 12 kHz/ })).toBeChecked()
    await userEvent.click(screen.getByRole('menuitemradio', { name: /^Train/ }))
    expect(await screen.findByText(/Heard as: train/, { selector: 'span' })).toBeVisible()
    fireEvent.keyDown(window, { key: '!', code: 'Digit1', shiftKey: true })
    await waitFor(() => expect(screen.queryByText(/Heard as: train/, { selector: 'span' })).toBeNull())
    expect(localStorage.getItem('soundlist-heard-as')).toBeNull()
  })

  test('older versions can be heard, and get no verdict', async () => {
    const old = aTake('old', { number: 3, state: 'change_requested' })
    serveReview(aReview(shield, { takes: [...shield.takes, old] }))
    await opened()
    await fromMore('Version 1 of 3')
    await userEvent.click(await screen.findByRole('menuitemradio', { name: /^Version 3/ }))
    await userEvent.keyboard('{Escape}')
    expect(await screen.findByText('A change was requested for this version.')).toBeVisible()
    expect(screen.queryByRole('button', { name: /^Approve / })).toBeNull()
    expect(screen.getByRole('slider')).toHaveAccessibleName('Position in shield_hit, version 3')
  })
})
