import { screen, within } from '@testing-library/react'
import axe from 'axe-core'
import { beforeAll, describe, expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { aTakeServer } from '@/test/take'

beforeAll(() => import('./TakePage'))

const NO_SOURCES = { take_id: 't1', stated: null, is_own: false, is_fixed: false, open_points: [] }
const SOUND = {
  take_id: 't9',
  project_id: 'p9',
  project_name: 'Night Harbour',
  cue: 'NH-003 Hull knock',
  version: 2,
  words: 'the same sound, 6.0 dB quieter',
  gain_db: -6,
  score: 0.99,
}
const aServerWith = (same: object) =>
  aTakeServer()
    .on('GET /v1/takes/t1/sources', NO_SOURCES)
    .on('GET /v1/takes/t1/same-sounds', { take_id: 't1', is_compared: true, sounds: [], libraries: [], ...same })
const card = () => screen.findByRole('region', { name: 'Sources' })

const FILE = {
  library: 'Doors & Gates',
  licence: 'Site licence 12',
  file: 'wood/door.wav',
  words: 'the same sound, 6.0 dB quieter',
  gain_db: -6,
  score: 0.99,
  is_declared: false,
}

describe('a file of a sound library', () => {
  test.each([
    [true, 'Declared in its sources.'],
    [false, 'Not declared in its sources.'],
  ])('is named with its licence, and whether it is declared (%s)', async (is_declared, words) => {
    aServerWith({ libraries: [{ ...FILE, is_declared }] })
    openApp('/takes/t1')
    const list = await within(await card()).findByRole('list', { name: 'Same sound in libraries' })
    expect(list).toHaveTextContent(
      `wood/door.wav of Doors & Gates (Site licence 12). This version is the same sound, 6.0 dB quieter. ${words}`,
    )
    expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  })
})

describe('a sound of another project', () => {
  test('is named with a link to it and how this version differs', async () => {
    aServerWith({ sounds: [SOUND] })
    openApp('/takes/t1')
    const list = await within(await card()).findByRole('list', { name: 'Same sound in other projects' })
    expect(list).toHaveTextContent('This version is the same sound, 6.0 dB quieter.')
    const link = within(list).getByRole('link', { name: 'Night Harbour: NH-003 Hull knock, version 2' })
    expect(link).toHaveAttribute('href', expect.stringContaining('/takes/t9'))
    expect((await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })).violations).toEqual([])
  })

  test.each([
    [true, 'No approved version of another project has the same sound.'],
    [false, 'Not compared with other projects yet.'],
  ])('is ruled out for the team once compared (%s)', async (is_compared, words) => {
    aServerWith({ is_compared })
    openApp('/takes/t1')
    expect(await within(await card()).findByText(words)).toBeInTheDocument()
  })

  test('is not mentioned to a designer who may see none', async () => {
    aServerWith({ is_compared: null })
    openApp('/takes/t1')
    expect(await within(await card()).findByText(/stated/)).toBeInTheDocument()
    expect(await card()).not.toHaveTextContent('another project')
  })
})
