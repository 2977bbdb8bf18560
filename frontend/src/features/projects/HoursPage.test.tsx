import { screen, within } from '@testing-library/react'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { refusal } from '@/test/server'
import { ListServer } from '@/test/soundList'

const week = (on: string, due: number, wanted: number, there: number | null, short = false) => ({
  week_on: on,
  due_h: due,
  wanted_h: wanted,
  there_h: there,
  is_short: short,
})

const DESIGNER = {
  designer: { id: 'd1', name: 'Sound designer' },
  cues: 5,
  unknown: 2,
  left_h: 38,
  done_h: 4.5,
  undated: 1,
  roster_entry_id: 'r1',
  weekly_hours: 20,
  weeks: [week('2026-11-23', 8, 8, 12), week('2026-11-30', 30, 38, 32, true)],
}

function opened(hours: unknown) {
  const server = new ListServer([])
  const project = server.path.replace('/sound-list', '')
  server.answers[`GET ${server.at}/hours`] = hours
  openApp(`${project}/hours`)
}

test('hours due stand against hours there, and the first week that is short is named', async () => {
  opened({
    total: { cues: 5, unknown: 2, left_h: 38, done_h: 4.5 },
    uncontracted: 3,
    categories: [{ category: 'weapon', cues: 5, unknown: 2, left_h: 38, done_h: 4.5 }],
    designers: [DESIGNER],
  })
  const card = await screen.findByRole('region', { name: 'Sound designer' })
  expect(card).toHaveTextContent('38 h left, 4 h 30 min logged; 2 cues without an estimate')
  expect(card).toHaveTextContent('By the end of the week of 30 November: 38 h due, 32 h there.')
  expect(card).toHaveTextContent('1 cue without a day is in no week.')
  expect(within(card).getByRole('img', { name: 'more is due than there is' })).toBeVisible()
  expect(screen.getByText('3 cues of the list are under no agreed contract: hours not known.')).toBeVisible()
  const { violations } = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(violations.map(({ id }) => id)).toEqual([])
})

test('without hours a week nothing is held against what is due', async () => {
  const unknown = { ...DESIGNER, weekly_hours: null, roster_entry_id: null, weeks: [week('2026-11-23', 8, 8, null)] }
  opened({
    total: { cues: 5, unknown: 2, left_h: 38, done_h: 4.5 },
    uncontracted: 0,
    categories: [],
    designers: [unknown],
  })
  expect(await screen.findByText(/Hours a week are not known/)).toBeVisible()
  expect(screen.getByText('not known')).toBeVisible()
  expect(screen.getByRole('link', { name: 'Put this designer on file' })).toHaveAttribute('href', '/roster')
})

test('without agreed work the page names where estimates come from', async () => {
  opened({ total: { cues: 0, unknown: 0, left_h: 0, done_h: 0 }, uncontracted: 4, categories: [], designers: [] })
  expect(await screen.findByText('No open contracted work')).toBeVisible()
})

test('a refusal is shown', async () => {
  opened(refusal(403, 'producer-needed', 'only a producer of the studio can do this'))
  expect(await screen.findByText(/only a producer of the studio can do this/i)).toBeVisible()
})
