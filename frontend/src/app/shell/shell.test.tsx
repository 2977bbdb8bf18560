import { QueryClient } from '@tanstack/react-query'
import { createMemoryHistory, createRoute, createRouter, RouterProvider } from '@tanstack/react-router'
import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { afterEach, expect, test, vi } from 'vitest'

import { useComparedBlind } from '@/verdicts/comparedBlind'
import { draw } from '@/test/draw'
import { serve } from '@/test/server'

import { router as product } from '../router'
import { notFoundRoute, rootRoute, shellRoute } from '../roots'
import type { ShellData } from '../session'
import { useTitle } from '../title'
import { areasOf, homeOf, HOMES } from './areas'

const PRODUCER: ShellData = {
  person: { name: 'Producer', role: 'Producer' },
  side: 'studio',
  project: { id: 'p1', name: 'Shield Wing' },
  projects: [
    { id: 'p1', name: 'Shield Wing' },
    { id: 'p2', name: 'Deep Field' },
  ],
  ndaOpen: false,
  speaks: true,
  hasContracts: true,
  isProducer: true,
  isImplementer: false,
  counts: { review: 4 },
  operates: true,
  signOut: vi.fn(),
}
const DESIGNER: ShellData = {
  ...PRODUCER,
  person: { name: 'Sound designer', role: 'Sound designer' },
  side: 'designer',
  isProducer: false,
  counts: { desk: 3 },
  operates: false,
}

// The routes of the product are shared with the files that run after this one.
const { children: ofRoot } = rootRoute
const { children: ofShell } = shellRoute
afterEach(() => {
  Object.assign(rootRoute, { children: ofRoot })
  Object.assign(shellRoute, { children: ofShell })
})

function Page({ name }: { name: string }) {
  useTitle(name)
  return (
    <div className="page">
      <h1>{name}</h1>
    </div>
  )
}

function page(path: string, name: string) {
  return createRoute({ getParentRoute: () => shellRoute, path, component: () => <Page name={name} /> })
}

async function open(data: ShellData, at = '/projects/p1/today', ensureSignedIn = () => Promise.resolve()) {
  const tree = rootRoute.addChildren([
    shellRoute.addChildren([
      page('/projects/$projectId/today', 'Today'),
      page('/projects/$projectId/sound-list', 'Sound list'),
      page('/projects/$projectId/builds', 'Builds'),
      page('/projects/$projectId/sound-list/cues/$cueId', 'Cue'),
      page('/desk', 'Desk'),
      createRoute({
        getParentRoute: () => shellRoute,
        path: '/broken',
        component: () => {
          throw new Error('a figure was missing')
        },
      }),
      notFoundRoute,
    ]),
  ])
  const router = createRouter({
    routeTree: tree,
    history: createMemoryHistory({ initialEntries: [at] }),
    context: { queryClient: new QueryClient(), session: { useShell: () => data, ensureSignedIn } },
  })
  // The app's own router is registered by type; this one has fewer pages.
  draw(<RouterProvider router={router as never} />)
  await screen.findByRole('main')
  return router
}

const tabs = () => within(screen.getByRole('navigation', { name: 'Areas' })).getAllByRole('link')
const pages = (area: string) =>
  within(screen.getByRole('navigation', { name: `Pages of ${area}` })).getAllByRole('link')
const labels = (data: ShellData) => areasOf(data).flatMap(({ label, isInMenu }) => (isInMenu ? [] : [label]))

test('the studio has seven areas; what waits is beside the area and beside its first page', async () => {
  await open(PRODUCER)
  expect(labels(PRODUCER)).toEqual(['Today', 'Sounds', 'Review', 'Game', 'People', 'Contract & money', 'Settings'])
  expect(tabs().map((tab) => tab.getAttribute('aria-current'))).toEqual(['page', ...Array<null>(6).fill(null)])
  expect(tabs()[2]).toHaveTextContent('Review4 waiting')
  expect(pages('Today').map((page) => page.textContent)).toEqual(['For you', 'Overview', 'Progress', 'Activity'])
  expect(pages('Today')[0]).toHaveAttribute('aria-current', 'page')
})

test('a page below another is marked as part of it, in both rows', async () => {
  expect(homeOf('/projects/p1/drift', PRODUCER)).toEqual({ area: 'game', label: 'Builds' })
  expect(homeOf('/projects/p1/sound-list/compare', PRODUCER)).toEqual({ area: 'sounds', label: 'List' })
  expect(homeOf('/studio/s1/security-log', PRODUCER)).toEqual({ area: 'you', label: 'Studio' })
  await open(PRODUCER, '/projects/p1/builds')
  expect(tabs().findIndex((tab) => tab.getAttribute('aria-current') === 'true')).toBe(3)
  expect(pages('Game').map((page) => page.textContent)).toEqual([
    'Packs',
    'Builds',
    'Placeholders',
    'In-game listening',
    'Tasks',
  ])
  expect(pages('Game')[1]).toHaveAttribute('aria-current', 'page')
})

test('the page that is open is brought into sight in the second row', async () => {
  const scrolled = vi.spyOn(Element.prototype, 'scrollIntoView')
  await open(PRODUCER, '/projects/p1/builds')
  expect(scrolled.mock.contexts).toEqual([pages('Game')[1]])
})

test('a designer begins with Deliveries', async () => {
  await open(DESIGNER, '/desk')
  expect(labels(DESIGNER)).toEqual(['Deliveries', 'Sounds', 'Review', 'Contract & money', 'Settings'])
  expect(tabs()[0]).toHaveTextContent('Deliveries3 waiting')
  expect(pages('Deliveries')[0]).toHaveTextContent('To do3 waiting')
})

const REVIEWER: ShellData = { ...PRODUCER, speaks: false, isProducer: false, operates: false }
const IMPLEMENTER: ShellData = { ...REVIEWER, isImplementer: true }

test('who implements has the game and no verdicts; who only reviews has no contract and no money', () => {
  expect(labels(IMPLEMENTER)).toEqual(['Today', 'Sounds', 'Game', 'Settings'])
  expect(labels(REVIEWER)).toEqual(['Today', 'Sounds', 'Review', 'Game', 'People', 'Settings'])
})

test('a server without contracts has no entry of contracts, money and hiring', () => {
  const producer = { ...PRODUCER, hasContracts: false }
  expect(labels(producer)).toEqual(['Today', 'Sounds', 'Review', 'Game', 'People', 'Settings'])
  const people = areasOf(producer).find(({ id }) => id === 'people')
  expect(people?.pages.map(({ label }) => label)).toEqual(['Team'])
  expect(labels({ ...DESIGNER, hasContracts: false })).toEqual(['Deliveries', 'Sounds', 'Review', 'Settings'])
})

test('without a project there are the pages that need none', () => {
  expect(labels({ ...PRODUCER, project: null })).toEqual(['Today', 'People', 'Settings'])
  expect(areasOf({ ...PRODUCER, person: null })).toEqual([])
})

/** Every address of the shell, with what is open in it. */
const addresses = Object.values(product.routesById as Record<string, { id: string; fullPath: string }>)
  .filter(({ id, fullPath }) => id.startsWith('/shell/') && fullPath !== '/$')
  .map(({ fullPath }) => fullPath.replace('$projectId', 'p1').replace(/\$\w+/g, 'x1'))

const OF_DESIGNERS = /^\/(work|postings|desk)/
const OF_LEADS = /(contracts|money|milestones|p1\/postings)/
const OF_PRODUCERS = /(tokens|webhooks|settings|operations)$/
const any = (...patterns: RegExp[]) => new RegExp(patterns.map(({ source }) => `(?:${source})`).join('|'))

test.each([
  ['a producer', PRODUCER, OF_DESIGNERS],
  ['an approver', { ...PRODUCER, isProducer: false, operates: false }, any(OF_DESIGNERS, OF_PRODUCERS)],
  ['a reviewer', REVIEWER, any(OF_DESIGNERS, OF_LEADS, OF_PRODUCERS)],
  [
    'an implementer',
    IMPLEMENTER,
    any(
      OF_DESIGNERS,
      OF_LEADS,
      OF_PRODUCERS,
      /(review|sharing|playlists|people|hours|credits|roster|approvers|approval)/,
    ),
  ],
  [
    'a designer',
    DESIGNER,
    any(
      OF_PRODUCERS,
      /(packs|game-files|builds|placeholders|people|hours|roster|p1\/postings|approvers|approval|studio)/,
    ),
  ],
])('every route has one home for %s', (_, viewer, notTheirs) => {
  expect(addresses.length).toBeGreaterThan(50)
  const homeless = addresses.filter((address) => homeOf(address, viewer) === undefined)
  expect(homeless.filter((address) => !notTheirs.test(address))).toEqual([])
  expect(
    homeless.every((address) => !areasOf(viewer).some(({ pages }) => pages.some(({ path }) => path === address))),
  ).toBe(true)
  for (const { path } of areasOf(viewer).flatMap((area) => area.pages)) expect(addresses).toContain(path)
})

test('the producer and the designer have homes for all routes together, and no two pages claim one address', () => {
  const homeless = addresses.filter((address) => [PRODUCER, DESIGNER].every((viewer) => !homeOf(address, viewer)))
  expect(homeless).toEqual([])
  for (const viewer of [PRODUCER, REVIEWER, IMPLEMENTER, DESIGNER]) {
    const claimed = HOMES.filter(({ sees }) => sees(viewer)).flatMap(({ routes }) => routes)
    expect(claimed.filter((route, index) => claimed.indexOf(route) !== index)).toEqual([])
  }
})

test('g s goes to the list; the head takes the focus and the title follows', async () => {
  await open(PRODUCER)
  await waitFor(() => expect(document.title).toBe('Today · Shield Wing · Soundlist'))
  await userEvent.keyboard('gs')
  const head = await screen.findByRole('heading', { name: 'Sound list', level: 1 })
  await waitFor(() => expect(head).toHaveFocus())
  expect(document.title).toBe('Sound list · Shield Wing · Soundlist')
})

test('the first stop of the keyboard leads past the bar', async () => {
  await open(PRODUCER)
  await userEvent.tab()
  expect(screen.getByRole('link', { name: 'Skip to content' })).toHaveFocus()
  expect(screen.getByRole('link', { name: 'Skip to content' })).toHaveAttribute('href', '#main')
  expect(screen.getByRole('main')).toHaveAttribute('id', 'main')
})

test('the palette goes to another project', async () => {
  const router = await open(PRODUCER)
  await userEvent.keyboard('{Control>}k{/Control}')
  await userEvent.type(await screen.findByRole('combobox', { name: 'Search or run a command' }), 'deep')
  await userEvent.keyboard('{Enter}')
  await waitFor(() => expect(router.state.location.pathname).toBe('/projects/p2'))
})

test('the palette finds a cue of another project and says which', async () => {
  const cue = { id: 'c9', label: 'DF-009', name: 'coolant_splash' }
  const hit = { kind: 'cue', title: cue.name, text: '', cue, project_id: 'p2', project_name: 'Deep Field' }
  const server = serve({
    'GET /v1/projects/p1/find': { hits: [] },
    'GET /v1/find': { hits: [{ ...hit, take_id: null, contract_id: null, start_s: null }] },
  })
  const router = await open(PRODUCER)
  await userEvent.keyboard('{Control>}k{/Control}')
  await userEvent.type(await screen.findByRole('combobox', { name: 'Search or run a command' }), 'splash')
  const found = await screen.findByRole('group', { name: 'In other projects' })
  await userEvent.click(within(found).getByRole('option', { name: /DF-009.*coolant_splash.*Deep Field/ }))
  await waitFor(() => expect(router.state.location.pathname).toBe('/projects/p2/sound-list/cues/c9'))
  const last = server.asked.findLast(({ path }) => path === '/v1/find')
  expect(last?.query.toString()).toBe('q=splash&except_in=p1')
})

const said = (kind: string, text: string, of: object = {}) => ({
  kind,
  title: 'shield_hit',
  text,
  cue: { id: 'c7', label: 'SW-007', name: 'shield_hit' },
  take_id: 't2',
  contract_id: null,
  start_s: null,
  said: { variation: 1, number: 2, by: { id: 'ada', name: 'Ada' }, on_behalf_of: null, at: null },
  ...of,
})

test('the palette finds versions by reasons and labels, here and in other projects, with who said it', async () => {
  const elsewhere = { project_id: 'p2', project_name: 'Deep Field', take_id: 't9' }
  serve({
    'GET /v1/projects/p1/find': {
      hits: [said('change_reason', 'Too long', { start_s: 0.25 }), said('label', 'long tail')],
    },
    'GET /v1/find': { hits: [said('pick_reason', 'Long but right', elsewhere)] },
  })
  const router = await open(PRODUCER)
  await userEvent.keyboard('{Control>}k{/Control}')
  await userEvent.type(await screen.findByRole('combobox', { name: 'Search or run a command' }), 'long')
  const found = await screen.findByRole('group', { name: 'Reasons and labels' })
  expect(
    within(found)
      .getAllByRole('option')
      .map((option) => option.textContent),
  ).toEqual([
    'SW-007Too longshield_hit version 2, change requested by AdaEnter',
    'SW-007long tailshield_hit version 2, labelled by Ada',
    'SW-007Long but rightDeep Field: shield_hit version 2, approved by Ada',
  ])
  expect(screen.queryByRole('group', { name: 'In other projects' })).not.toBeInTheDocument()
  await userEvent.click(within(found).getByRole('option', { name: /Too long/ }))
  await waitFor(() => expect(router.state.location.href).toBe('/takes/t2?at=0.25'))
})

function ComparesBlind({ cueId }: { cueId: string }) {
  useComparedBlind(cueId)
  return null
}

test('the palette shows no reason or label of a cue whose versions are compared blind', async () => {
  const other = { cue: { id: 'c8', label: 'SW-008', name: 'door_open' }, title: 'door_open' }
  serve({
    'GET /v1/projects/p1/find': {
      hits: [said('change_reason', 'layered too much'), said('label', 'layered'), said('label', 'layered', other)],
    },
    'GET /v1/find': { hits: [] },
  })
  await open(PRODUCER)
  draw(<ComparesBlind cueId="c7" />)
  await userEvent.keyboard('{Control>}k{/Control}')
  await userEvent.type(await screen.findByRole('combobox', { name: 'Search or run a command' }), 'layered')
  const found = await screen.findByRole('group', { name: 'Reasons and labels' })
  expect(
    within(found)
      .getAllByRole('option')
      .map((option) => option.textContent),
  ).toEqual(['SW-008layereddoor_open version 2, labelled by AdaEnter'])
})

test('the menu says who one is, and lets one out', async () => {
  await open(PRODUCER)
  await userEvent.click(screen.getByRole('button', { name: /^Producer/ }))
  await userEvent.click(await screen.findByRole('menuitem', { name: 'Sign out' }))
  expect(PRODUCER.signOut).toHaveBeenCalledOnce()
})

test('an address that nobody knows keeps the frame and the ways on', async () => {
  await open(PRODUCER, '/no/such/place')
  expect(screen.getByRole('heading', { name: 'Page not found', level: 1 })).toBeInTheDocument()
  expect(screen.getByRole('link', { name: 'All projects' })).toHaveAttribute('href', '/projects')
  expect(tabs()).toHaveLength(7)
})

test('a page that breaks says so and can be tried again', async () => {
  vi.spyOn(console, 'error').mockImplementation(() => undefined)
  await open(PRODUCER, '/broken')
  const alert = await screen.findByRole('alert')
  expect(alert).toHaveTextContent('This page could not be loaded.')
  expect(alert).toHaveTextContent('a figure was missing')
  expect(within(alert).getByRole('button', { name: 'Try again' })).toBeInTheDocument()
})

test('before anyone is let in, nothing of the page is shown', async () => {
  vi.spyOn(console, 'error').mockImplementation(() => undefined)
  await open(PRODUCER, '/projects/p1/today', () => Promise.reject(new Error('the server is away')))
  expect(await screen.findByRole('alert')).toHaveTextContent('This page could not be loaded.')
  expect(screen.queryByRole('heading', { name: 'Today' })).not.toBeInTheDocument()
})
