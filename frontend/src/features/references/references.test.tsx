import { fireEvent, screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import axe from 'axe-core'
import { expect, test } from 'vitest'

import { openApp } from '@/test/openApp'
import { inProject } from '@/test/project'
import { answer, type Asked, refusal, serve, wrote } from '@/test/server'

import { bodyOfPin, groupsOf, pinOf, secondsOf } from './pins'

const AT = '2026-11-20T10:00:00Z'
const PRODUCER = { id: 'x1', name: 'Producer' }

const version = (id: string, kind: string, more: object = {}) => ({
  id,
  number: 1,
  kind,
  media_type: 'x',
  file_name: `${id}.bin`,
  url: null,
  file_bytes: 2_000,
  excerpt: '',
  preview: 'none',
  problem: '',
  width_px: null,
  height_px: null,
  added_at: AT,
  added_by: PRODUCER,
  ...more,
})
const reference = (id: string, of: object, more: object = {}) => ({
  id,
  project_id: 'p1',
  cue: null,
  category: null,
  caption: '',
  terms: '',
  words: '',
  start_s: null,
  end_s: null,
  added_at: AT,
  version: of,
  may_change: true,
  ...more,
})

const SPLASH = { id: 'c1', number: 7, name: 'coolant_splash' }
const ITEMS = [
  reference('r1', version('v1', 'picture', { preview: 'made' }), { cue: SPLASH, caption: 'Coolant tank' }),
  reference('r2', version('v2', 'audio'), {
    cue: SPLASH,
    caption: 'A drop',
    start_s: 41.2,
    end_s: 43,
    terms: 'May not be shipped',
    words: '',
  }),
  reference('r3', version('v3', 'text', { excerpt: 'The lights go out.' }), { category: 'impact', caption: 'Scene' }),
  reference(
    'r4',
    version('v4', 'link', { url: 'https://example.test/a', file_name: 'example.test', file_bytes: null }),
  ),
  reference('r5', version('v5', 'picture', { preview: 'refused', problem: 'this picture is damaged' })),
]
const OPENING = { caption: 'A drop', file_name: 'v2.bin', reference_id: 'r2', version: 1, is_removed: false }

function open(part: 'producer' | 'designer' = 'producer', items: object[] = ITEMS, more: object = {}) {
  const { asked } = serve(
    inProject(part, {
      'GET /v1/projects/p1/desk': refusal(403, 'x', 'no desk'),
      'GET /v1/projects/p1/references': {
        items: items.map((one) => ({ ...one, may_change: part === 'producer' })),
        next: null,
      },
      'GET /v1/projects/p1/sound-list': {
        revision: 1,
        next: null,
        cues: [{ id: 'c1', label: 'SW-007', name: 'coolant_splash', category: 'impact', state: 'locked' }],
      },
      ...Object.fromEntries(
        [1, 2, 3, 4, 5].map((at) => [`POST /v1/reference-versions/v${at}/openings`, answer(null, 204)]),
      ),
      'GET /v1/references/r2/versions': [version('v2', 'audio')],
      'GET /v1/projects/p1/reference-openings': {
        items: [{ ...OPENING, person: { id: 'x3', name: 'Sound designer' }, opened_at: AT }],
        next: null,
      },
      ...more,
    }),
  )
  openApp('/projects/p1/references')
  return asked
}

test('the board stands in groups, each reference with its part and its terms', async () => {
  open()
  const cue = await screen.findByRole('region', { name: 'coolant_splash' })
  expect(within(cue).getAllByRole('article')).toHaveLength(2)
  const drop = within(cue).getByRole('article', { name: 'A drop' })
  expect(drop).toHaveTextContent('May not be shipped')
  expect(drop).toHaveTextContent(/Sound, 0:41\.2.*0:43\.0/)
  const headings = screen.getAllByRole('heading', { level: 2 }).map(({ textContent }) => textContent)
  expect(headings).toEqual(['Add', 'Whole project', 'impact', 'coolant_splash'])
  expect(screen.getByText(/this picture is damaged/)).toBeVisible()
  const found = await axe.run(document.body, { rules: { 'color-contrast': { enabled: false } } })
  expect(found.violations.map(({ id }) => id)).toEqual([])
})

test('a sound is on record before it plays, in place and from the part that is meant', async () => {
  const asked = open('designer')
  await userEvent.click(await screen.findByRole('button', { name: 'Play A drop' }))
  const player = await waitFor(() => {
    const found = document.querySelector('audio')
    expect(found).not.toBeNull()
    return found
  })
  expect(player).toHaveAttribute('src', '/v1/reference-versions/v2/file#t=41.2,43')
  expect(wrote(asked, 'POST /v1/reference-versions/v2/openings')).toHaveLength(1)
  if (player) fireEvent.error(player)
  expect(await screen.findByText('This browser can’t play it.')).toBeVisible()
})

test('a picture opens over the page, and Escape closes it', async () => {
  const asked = open('designer')
  await userEvent.click(await screen.findByRole('button', { name: 'Show Coolant tank' }))
  const dialog = await screen.findByRole('dialog', { name: 'Coolant tank' })
  expect(within(dialog).getByRole('img')).toHaveAttribute('src', '/v1/reference-versions/v1/view')
  expect(wrote(asked, 'POST /v1/reference-versions/v1/openings')).toHaveLength(1)
  await userEvent.keyboard('{Escape}')
  await waitFor(() => expect(screen.queryByRole('dialog')).toBeNull())
})

test('an opening that is refused says why where it happened', async () => {
  open('designer', ITEMS, {
    'POST /v1/reference-versions/v1/openings': refusal(404, 'reference-not-found', 'It was removed.'),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Show Coolant tank' }))
  expect(await screen.findByRole('alert')).toHaveTextContent('It was removed.')
  expect(screen.queryByRole('dialog')).toBeNull()
})

test('a link leads elsewhere without saying where from', async () => {
  open('designer')
  const link = await screen.findByRole('link', { name: /example\.test in a new tab/ })
  expect(link).toHaveAttribute('href', 'https://example.test/a')
  expect(link.getAttribute('rel')).toContain('noreferrer')
})

test('j and k go from one reference to the next', async () => {
  open('designer')
  await screen.findByRole('button', { name: 'Play A drop' })
  await userEvent.keyboard('jj')
  expect(document.activeElement?.closest('article')).toHaveAccessibleName('v5.bin')
  await userEvent.keyboard('k')
  expect(document.activeElement?.closest('article')).toHaveAccessibleName('example.test')
})

test('a designer adds and changes nothing, and an empty board says what will be there', async () => {
  open('designer', [])
  expect(await screen.findByText('No references yet')).toBeVisible()
  expect(screen.getByText(/team has not added any yet/)).toBeVisible()
  expect(screen.queryByRole('button', { name: /Add files/ })).toBeNull()
})

test('a link is added with what it is for; what was refused stays as it was typed', async () => {
  const answers = [
    refusal(422, 'reference-invalid', 'only https', { errors: [{ where: 'url', message: 'only https' }] }),
    answer(ITEMS[3], 201),
  ]
  const asked = open('producer', [], { 'POST /v1/projects/p1/references': () => answers.shift() })
  expect(await screen.findByText(/what words do not say/)).toBeVisible()
  await screen.findByRole('option', { name: 'impact' })
  await userEvent.selectOptions(screen.getByLabelText('Pin to'), 'category:impact')
  fireEvent.change(screen.getByLabelText('Link'), { target: { value: 'http://example.test' } })
  fireEvent.change(screen.getByLabelText('Caption'), { target: { value: 'The walkway' } })
  await userEvent.click(screen.getByRole('button', { name: 'Add link' }))
  expect(await screen.findByText('Only https.')).toBeVisible()
  expect(screen.getByLabelText('Caption')).toHaveValue('The walkway')
  fireEvent.change(screen.getByLabelText('Link'), { target: { value: 'https://example.test' } })
  await userEvent.click(screen.getByRole('button', { name: 'Add link' }))
  await waitFor(() => expect(wrote(asked, 'POST /v1/projects/p1/references')).toHaveLength(2))
  expect(wrote(asked, 'POST /v1/projects/p1/references')[1]?.body).toEqual({
    url: 'https://example.test',
    caption: 'The walkway',
    terms: '',
    words: '',
    cue_id: null,
    category: 'impact',
  })
  expect(await screen.findByText('Link added to the board.')).toBeVisible()
})

test('what is said of a reference is changed beside its versions and who opened it', async () => {
  const asked = open('producer', ITEMS, {
    'PATCH /v1/references/r2': ({ body }: Asked) => answer({ ...ITEMS[1], ...(body as object) }),
    'DELETE /v1/references/r2': answer(null, 204),
  })
  await userEvent.click(await screen.findByRole('button', { name: 'Edit A drop' }))
  const dialog = await screen.findByRole('dialog', { name: 'A drop' })
  expect(await within(dialog).findByText(/Sound designer, version 1/)).toBeVisible()
  const from = within(dialog).getByLabelText('From')
  fireEvent.change(from, { target: { value: 'soon' } })
  await userEvent.click(within(dialog).getByRole('button', { name: 'Save' }))
  expect(await within(dialog).findByText(/Seconds, as in 41\.2/)).toBeVisible()
  fireEvent.change(from, { target: { value: '0:40' } })
  await userEvent.click(within(dialog).getByRole('button', { name: 'Save' }))
  await waitFor(() => expect(wrote(asked, 'PATCH /v1/references/r2')).toHaveLength(1))
  expect(wrote(asked, 'PATCH /v1/references/r2')[0]?.body).toMatchObject({ start_s: 40, end_s: 43, cue_id: 'c1' })
  await waitFor(() => expect(screen.queryByRole('dialog')).toBeNull())
  await userEvent.click(screen.getByRole('button', { name: 'Edit A drop' }))
  await userEvent.click(await screen.findByRole('button', { name: 'Remove' }))
  expect(await screen.findByText('Reference removed from the board.')).toBeVisible()
})

test('a clip says how many cues follow its new version', async () => {
  open('producer', [{ ...ITEMS[1], parts: 2 }])
  await userEvent.click(await screen.findByRole('button', { name: 'Edit A drop' }))
  const dialog = await screen.findByRole('dialog', { name: 'A drop' })
  expect(
    within(dialog).getByText(/^2 cues were spotted from this clip: a new version is shown there too/),
  ).toBeVisible()
})

test('pins and seconds are read both ways', () => {
  const [picture, , text, link] = ITEMS as unknown as Parameters<typeof groupsOf>[0]
  if (!picture || !text || !link) throw new Error('no items')
  expect([picture, text, link].map(pinOf)).toEqual(['cue:c1', 'category:impact', ''])
  expect(bodyOfPin('cue:c1')).toEqual({ cue_id: 'c1', category: null })
  expect(bodyOfPin('')).toEqual({ cue_id: null, category: null })
  expect(groupsOf([picture, link, text]).map(({ kind }) => kind)).toEqual(['project', 'category', 'cue'])
  expect(['', ' 41,2', '1:05.5', '0:60', 'x', '-1', '1e3'].map(secondsOf)).toEqual([
    null,
    41.2,
    65.5,
    undefined,
    undefined,
    undefined,
    undefined,
  ])
})
