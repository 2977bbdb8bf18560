import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { aDraft, aPreview, aReview } from '@/test/review'
import { opened, posts, server, serveReview, serveReviewPage, walk } from '@/test/reviewPage'

beforeAll(() => Promise.all([import('./ReviewPage'), import('./ReviewStart')]))
serveReviewPage()

describe('a set', () => {
  test('is accepted with one version of each variation', async () => {
    server.on('POST /v1/cues/walk/accept-set', {})
    await opened('/walk')
    await userEvent.keyboard('a')
    await waitFor(() =>
      expect(server.of('POST /v1/cues/walk/accept-set')[0]?.body).toEqual({
        note: '',
        reasons: [],
        take_ids: ['w1', 'w2'],
        heard_take_ids: ['w1', 'w2'],
      }),
    )
    expect(await screen.findByRole('heading', { name: 'shield_hit', level: 1 })).toBeVisible()
  })

  test('with two versions of one variation names which one it takes and which gives way', async () => {
    const [w1, w2] = walk.takes
    if (!w1 || !w2) throw new Error('the set has two variations')
    const twice = { ...w2, id: 'w3', number: 2, file_name: 'foot_deck_walk_02 FINAL (2).wav' }
    server.on('GET /v1/sounds/w3/preview', aPreview)
    serveReview(aReview({ ...walk, takes: [w1, w2, twice] }))
    await opened('/walk')
    const bar = screen.getByRole('region', { name: 'Verdict' })
    expect(bar).toHaveTextContent('Approves all 2 variations at once. Takes _02 B; _02 A is set aside.')
    await userEvent.keyboard('2')
    expect(bar).toHaveTextContent('Takes _02 A; _02 B is set aside.')
  })

  test('with two files of one delivery between which nobody chose asks for the choice and promises nothing', async () => {
    const [w1, w2] = walk.takes
    if (!w1 || !w2) throw new Error('the set has two variations')
    const takes = [
      w1,
      { ...w2, undecided_with: ['w3'] },
      { ...w2, id: 'w3', number: 2, file_name: 'foot_deck_walk_02 FINAL (2).wav', undecided_with: ['w2'] },
    ]
    server.on('GET /v1/sounds/w3/preview', aPreview)
    serveReview(aReview({ ...walk, takes }))
    await opened('/walk')
    const bar = screen.getByRole('region', { name: 'Verdict' })
    expect(bar).toHaveTextContent('Choose first: _02 A and _02 B came in one delivery for the same sound')
    expect(bar).not.toHaveTextContent(/Approves all|Takes|set aside|is due/)
    await userEvent.keyboard('2')
    expect(bar).toHaveTextContent('Approves all 2 variations at once. Takes _02 A; _02 B is set aside.')
  })

  test('is played as the game does, at a rate and with pitch and level that stray, as chosen the last time', async () => {
    await opened('/walk')
    await userEvent.keyboard('{Shift>}h{/Shift}')
    const panel = await screen.findByRole('region', { name: 'How the set is played' })
    await userEvent.click(within(panel).getByRole('button', { name: '600 a minute' }))
    await userEvent.selectOptions(within(panel).getByLabelText('Pitch'), '± 2 semitones')
    await userEvent.selectOptions(within(panel).getByLabelText('Level'), '± 3 dB')
    expect(JSON.parse(localStorage.getItem('soundlist-set-way') ?? '')).toEqual({
      intervalS: 0.1,
      pitchSemitones: 2,
      levelDb: 3,
    })
    expect((await axe.run(panel, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
    await userEvent.click(within(panel).getByRole('button', { name: 'Play the set' }))
    await userEvent.click(await within(panel).findByRole('button', { name: 'Stop' }))
    await userEvent.click(within(panel).getByRole('button', { name: 'One after another' }))
    await userEvent.keyboard('{Escape}')
    expect(screen.queryByRole('region', { name: 'How the set is played' })).toBeNull()
    localStorage.removeItem('soundlist-set-way')
  })

  test('a noted variation keeps it from being accepted whole', async () => {
    const [w1, w2] = walk.takes
    if (!w1 || !w2) throw new Error('the set has two variations')
    serveReview(aReview({ ...walk, takes: [w1, { ...w2, draft_change: aDraft(w2, walk.cue, 'Too loud.') }] }))
    await opened('/walk')
    expect(screen.queryByRole('button', { name: 'Accept the set' })).toBeNull()
    expect(screen.getByRole('button', { name: 'Approve _01' })).toBeVisible()
  })

  test('selected variations get one change together', async () => {
    server.on('POST /v1/takes/w1/verdict', {}).on('POST /v1/takes/w2/verdict', {})
    await opened('/walk')
    await userEvent.keyboard('xb{Shift>}X{/Shift}')
    await userEvent.keyboard('.')
    expect(await screen.findByRole('menuitem', { name: 'Approve only 2 variations' })).toBeVisible()
    await userEvent.keyboard('{Escape}')
    await userEvent.keyboard('rless scrape{Enter}')
    await waitFor(() =>
      expect(posts().map(({ path }) => path)).toEqual(['/v1/takes/w1/verdict', '/v1/takes/w2/verdict']),
    )
    expect(posts()[1]?.body).toMatchObject({ kind: 'request_change', note: 'less scrape' })
  })
})
