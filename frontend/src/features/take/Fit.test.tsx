import { screen, waitFor, within } from '@testing-library/react'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { aMe, PROJECT } from '@/test/review'
import { refusal } from '@/test/server'
import { aTakeServer } from '@/test/take'

import { axisOf, type MeasureFit, moved } from './fit'

beforeAll(() => Promise.all([import('./TakePage'), import('./DeliveryFitPage')]))

const cue = (name: string) => ({ id: name, label: 'SW-001', name })
const LOUDNESS: MeasureFit = {
  measure: 'loudness',
  unit: 'LUFS',
  value: -12,
  middle: -18,
  lowest: -20,
  highest: -17,
  stands: 'above',
  others: [
    { cue: cue('ui_back'), is_palette: true, value: -20 },
    { cue: cue('ui_click'), is_palette: false, value: -18 },
    { cue: cue('ui_open'), is_palette: false, value: -17 },
  ],
}
const TIMBRE: MeasureFit = { ...LOUDNESS, measure: 'timbre', unit: 'dB', value: 1, lowest: 1.5, highest: 2, middle: 2 }
const aFit = (fit: object = {}) => ({
  take_id: 't1',
  file_name: 'airlock_cycle_02.wav',
  cue: cue('airlock_cycle'),
  basis: 'category',
  category: 'ui',
  says: 'Stands apart: louder than all of them, by 5.0 LU.',
  is_apart: true,
  measures: [LOUDNESS, { ...TIMBRE, stands: 'within', others: LOUDNESS.others.slice(0, 2) }],
  first_delivery_id: null,
  sounds_like: [
    { cue: cue('ui_open'), take_id: 't8', distance_db: 0.42 },
    { cue: cue('ui_back'), take_id: 't9', distance_db: 3.1 },
  ],
  ...fit,
})
const forTheTeam = (fit: object) => aTakeServer().on('GET /v1/me', aMe()).on('GET /v1/takes/t1/fit', aFit(fit))
const card = () => screen.findByRole('region', { name: 'Match with the palette' })

describe('a version among the approved sounds', () => {
  test('is drawn by every measure, and shown as a table', async () => {
    forTheTeam({})
    openApp('/takes/t1')
    const shown = await card()
    expect(shown).toHaveTextContent('compared with the approved sounds in ui')
    expect(shown).toHaveTextContent('louder than all of them, by 5.0 LU.')
    expect(shown).toHaveTextContent('Sounds like ui_open (0.4 dB), ui_back (3.1 dB).')
    expect(within(shown).getByRole('link', { name: 'ui_open' })).toHaveAttribute('href', '/takes/t8')
    const [loudness] = within(shown).getAllByRole('img')
    expect(loudness).toHaveAccessibleName('Loudness: −12.0 LUFS; 3 others from −20.0 LUFS to −17.0 LUFS')
    expect(loudness?.querySelectorAll('circle')).toHaveLength(3)
    expect(loudness?.querySelectorAll('circle[data-palette]')).toHaveLength(1)
    expect(loudness?.querySelector('path')).toHaveAttribute('data-apart')
    const rows = within(shown).getAllByRole('row', { hidden: true })
    expect(rows.map((row) => [...row.children].map((cell) => cell.textContent))).toEqual([
      ['Sound', 'Loudness', 'Timbre, distance from median'],
      ['airlock_cycle, this sound', '−12.0 LUFS', '1.0 dB'],
      ['median of the others', '−18.0 LUFS', '2.0 dB'],
      ['ui_back, palette', '−20.0 LUFS', '−20.0 dB'],
      ['ui_click', '−18.0 LUFS', '−18.0 dB'],
      ['ui_open', '−17.0 LUFS', 'not measured'],
    ])
    expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  })

  test('that has nothing to be compared with says why', async () => {
    forTheTeam({ basis: null, measures: [], is_apart: false, says: 'The list marks no cue as the palette.' })
    openApp('/takes/t1')
    expect(await card()).toHaveTextContent('The list marks no cue as the palette.')
    expect(within(await card()).queryByRole('img')).toBeNull()
  })

  test('leads from a first delivery to the comparison of all of it', async () => {
    forTheTeam({ first_delivery_id: 'd1' })
    openApp('/takes/t1')
    const link = await screen.findByRole('link', { name: 'Compare the whole delivery with earlier work' })
    expect(link).toHaveAttribute('href', '/deliveries/d1/fit')
  })

  test('is asked for by its designer too', async () => {
    const server = aTakeServer()
    openApp('/takes/t1')
    await screen.findByRole('region', { name: 'Measurements' })
    await waitFor(() => expect(server.asked.filter(({ path }) => path.endsWith('/fit'))).toHaveLength(1))
  })
})

describe('a delivery beside the work before', () => {
  const aDelivery = (fit: object = {}) => ({
    delivery_id: 'd1',
    project_id: PROJECT,
    number: 4,
    designer: { id: 'p', name: 'Jo' },
    is_first: true,
    made_before_by: ['Sound designer'],
    takes: [aFit()],
    shifts: [{ measure: 'loudness', unit: 'LUFS', compared: 1, apart: 1, shift: 6 }],
    ...fit,
  })
  const opened = (reply: unknown) => {
    aTakeServer().on('GET /v1/me', aMe()).on('GET /v1/deliveries/d1/fit', reply)
    return openApp('/deliveries/d1/fit')
  }

  test('is described as a whole and sound by sound', async () => {
    opened(aDelivery())
    await screen.findByRole('heading', { level: 1, name: 'Delivery 4 compared with earlier work' })
    const whole = screen.getByRole('table', { name: 'The delivery overall' })
    expect(within(whole).getAllByRole('row')[1]).toHaveTextContent('Loudness+6.0 LU1 of 1')
    expect(screen.getByRole('link', { name: 'airlock_cycle' })).toHaveAttribute('href', '/takes/t1')
    expect(screen.getByText('airlock_cycle_02.wav')).toBeInTheDocument()
    expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  })

  test('says what is missing where nothing can be compared, and that it is not here', async () => {
    opened(aDelivery({ made_before_by: [], takes: [], shifts: [] }))
    expect(await screen.findByText('No sound by another designer is approved in this project.')).toBeInTheDocument()
  })

  test('of another person is not here', async () => {
    opened(refusal(404, 'delivery-not-found', 'no delivery d1'))
    expect(await screen.findByText('Delivery not found')).toBeInTheDocument()
    expect(screen.getByRole('link', { name: 'Go to the start page' })).toBeInTheDocument()
  })
})

test('an axis reaches from the least to the most, and no closer than hearing asks', () => {
  expect(axisOf(LOUDNESS)).toEqual([-22, -10])
  expect(axisOf({ ...LOUDNESS, measure: 'dryness', value: 0.4, others: [] })).toEqual([0, 1])
  expect(axisOf({ ...TIMBRE, others: [] })).toEqual([0, 8])
  expect([moved('loudness', -1.25), moved('dryness', 0.2)]).toEqual(['−1.3 LU', '+0.20'])
})
