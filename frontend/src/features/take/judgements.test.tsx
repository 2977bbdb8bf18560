import { screen, within } from '@testing-library/react'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { aCheck } from '@/test/take'
import { card, opened, server, serveTakePage } from '@/test/takePage'

beforeAll(() => import('./TakePage'))
serveTakePage()

describe('the judgement of reverb', () => {
  const decay = {
    start_s: 0.8,
    step_s: 0.05,
    bands: [
      { hz: 500, rt60_s: 1.82, rate_db_s: -33, curve_db: [0, -2, -20, -45] },
      { hz: 4000, rt60_s: null, rate_db_s: null, curve_db: [0, -9] },
    ],
  }
  const judged = (coherence: unknown) =>
    aCheck({
      judgements: { reverb: { verdict: 'reverb', score: 0.99, rt60_s: 1.8, evidence: { decay, coherence } } },
    })

  test('shows what it goes by, octave for octave', async () => {
    server.on('GET /v1/takes/t1/check', judged([{ hz: 500, head: 0.97, tail: 0.31 }]))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('reverb, about 1.8 s, score 0.99')
    expect(within(shown).getByRole('img')).toHaveAccessibleName(/2 octaves over 0.15 s/)
    const rows = within(within(shown).getByRole('table')).getAllByRole('row')
    expect(rows.map((row) => row.textContent)).toEqual([
      'OctaveRT60RateL/R correlation, start to tail',
      '500 Hz1.82 s−33 dB/s0.97 to 0.31',
      '4 kHztoo short to measureno tail to compare',
    ])
  })

  test('says nothing of left and right in mono', async () => {
    server.on('GET /v1/takes/t1/check', judged(null))
    await opened()
    expect(await card('Reverb?')).not.toHaveTextContent('Left')
  })

  test('draws nothing where nothing could be judged', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { verdict: 'undecided', score: null } } }))
    await opened()
    await card('Measurements')
    expect(screen.queryByRole('region', { name: 'Reverb?' })).toBeNull()
  })
})

describe('reverb beside the version before', () => {
  const band = { hz: 500, curve_db: [0, -20, -40], rt60_s: 1.82, rate_db_s: -33 }
  const evidence = { decay: { start_s: 0, step_s: 0.05, bands: [band] }, coherence: null }
  const reverb = { verdict: 'reverb', score: 0.99, rt60_s: 1.8, evidence }
  const bands = [
    { hz: 500, rt60_s: 1.82, earlier_rt60_s: 0.2 },
    { hz: 1000, rt60_s: 0.22, earlier_rt60_s: 0.21 },
  ]
  const before = { take_id: 't0', number: 1, verdict: 'more reverb', rt60_s: 1.75, wet_db: -6.2, evidence: { bands } }

  test('says which has more, by how much, and where tails are slower', async () => {
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { ...reverb, before } } }))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('Compared with version 1: more reverb.')
    expect(shown).toHaveTextContent('is 6.2 dB under the sound and falls by 60 dB in 1.75 s')
    expect(within(shown).getByRole('link', { name: 'Compared with version 1' })).toHaveAttribute('href', '/takes/t0')
    const tails = within(within(shown).getByRole('list', { name: 'Tails compared with version 1' })).getAllByRole(
      'listitem',
    )
    expect(tails.map((tail) => tail.textContent)).toEqual(['500 Hz: 1.62 s slower'])
  })

  test('says that another sound cannot be compared', async () => {
    const other = { ...before, verdict: 'undecided', rt60_s: null, wet_db: null }
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { reverb: { ...reverb, before: other } } }))
    await opened()
    const shown = await card('Reverb?')
    expect(shown).toHaveTextContent('Compared with version 1: not the same sound')
    expect(within(shown).queryByRole('list')).toBeNull()
  })
})

test('the judgement of direction shows how each octave rises and falls', async () => {
  const bands = [
    { hz: 500, rise_db_s: 1200, fall_db_s: 80 },
    { hz: 4000, rise_db_s: 900, fall_db_s: 240 },
  ]
  server.on(
    'GET /v1/takes/t1/check',
    aCheck({ judgements: { reversed: { verdict: 'forwards', score: 0.03, evidence: { bands } } } }),
  )
  await opened()
  const shown = await card('Reversed?')
  expect(shown).toHaveTextContent('forwards, score 0.03')
  const rows = within(within(shown).getByRole('table')).getAllByRole('row')
  expect(rows.map((row) => row.textContent)).toEqual([
    'OctaveRisesFallsRise beside fall',
    '500 Hz1,200 dB/s80 dB/s',
    '4 kHz900 dB/s240 dB/s',
  ])
  expect((await axe.run(shown)).violations.map(({ id }) => id)).toEqual([])
})

test('the judgement of a lower rate shows the spectrum, and asks', async () => {
  const spectrum = { step_hz: 6_000, dbfs: [-40, -60, -130, -131] }
  const judged = { verdict: 'upsampled', score: 0.99, from_hz: 24_000, edge_hz: 11_900, drop_db: 71.5 }
  server.on('GET /v1/takes/t1/check', aCheck({ judgements: { upsampled: { ...judged, evidence: { spectrum } } } }))
  await opened()
  const shown = await card('Upsampled?')
  expect(shown).toHaveTextContent('upsampled, score 0.99')
  expect(shown).toHaveTextContent('That matches resampling from 24 kHz.')
  expect(within(shown).getByRole('img')).toHaveAccessibleName(
    'Mean spectrum from 0 Hz to 24.0 kHz. Its spectrum ends at 11.9 kHz, dropping by 71.5 dB.',
  )
  expect(shown.querySelector('polyline')?.getAttribute('points')?.split(' ')).toHaveLength(4)
})

describe('the judgement of lossy coding', () => {
  const spectrum = { step_hz: 6_000, dbfs: [-40, -60, -130, -131] }
  const frames = { codec: 'MP3', rate_hz: 44_100, frame: 576, shares: [0.03, 0.04, 0.42, 0.03] }
  const judged = { verdict: 'lossy', score: 0.99, codec: 'MP3', coded_at_hz: 44_100, silent_share: 0.42 }

  test('shows the place where the codec’s frames stand and where the spectrum ends, and asks', async () => {
    const figures = { ...judged, elsewhere_share: 0.04, low_pass_hz: 16_100 }
    server.on(
      'GET /v1/takes/t1/check',
      aCheck({ judgements: { lossy: { ...figures, evidence: { spectrum, frames } } } }),
    )
    await opened()
    const shown = await card('Was it converted from a lossy file?')
    expect(shown).toHaveTextContent('lossy, score 0.99')
    expect(shown).toHaveTextContent('One position stands out, 42 % against 4 % elsewhere')
    expect(within(shown).getByRole('img', { name: /lines of MP3 at 576 places, at most 42 %/ })).toBeInTheDocument()
    expect(within(shown).getByRole('img', { name: /It ends steeply at 16.1 kHz/ })).toBeInTheDocument()
    expect(shown.querySelectorAll('[data-most]')).toHaveLength(1)
  })

  test('of a clean sound shows that no place stands out', async () => {
    const clean = { verdict: 'clean', score: 0.02, codec: null, low_pass_hz: null, elsewhere_share: null }
    server.on('GET /v1/takes/t1/check', aCheck({ judgements: { lossy: { ...clean, evidence: { spectrum, frames } } } }))
    await opened()
    const shown = await card('Was it converted from a lossy file?')
    expect(shown).toHaveTextContent('No position stands out')
    expect(within(shown).getAllByRole('img')).toHaveLength(1)
  })
})
