import { QueryClient } from '@tanstack/react-query'
import { createMemoryHistory, createRoute, createRouter, RouterProvider } from '@tanstack/react-router'
import { screen, waitFor, within } from '@testing-library/react'
import userEvent from '@testing-library/user-event'
import { afterEach, expect, test, vi } from 'vitest'

import { useComparedBlind } from '@/judging/comparedBlind'
import { draw } from '@/test/draw'
import { serve } from '@/test/server'

import { nowhereRoute, rootRoute, shellRoute } from '../roots'
import type { ShellData } from '../session'
import { useTitle } from '../title'
import { screenOf, screensOf } from './screens'

const PRODUCER: ShellData = {
  person: { name: 'Producer', role: 'Producer' },
  side: 'studio',
  project: { id: 'p1', name: 'Shield Wing' },
  projects: [
    { id: 'p1', name: 'Shield Wing' },
    { id: 'p2', name: 'Deep Field' },
  ],
  ndaOpen: false,
  isParty: true,
  counts: { review: 4 },
  operates: true,
  signOut: vi.fn(),
}
const DESIGNER: ShellData = {
  ...PRODUCER,
  person: { name: 'Sound designer', role: 'Sound designer' },
  side: 'designer',
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
      nowhereRoute,
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

const tabs = () => within(screen.getByRole('navigation', { name: 'Screens' })).getAllByRole('link')

test('the studio has Today, Sound list, Review and Project; what waits is beside its tab', async () => {
  await open(PRODUCER)
  expect(tabs().map((tab) => tab.textContent)).toEqual([
    'Today',
    'Sound list',
    'Review4 waiting',
    'Contract',
    'Project',
  ])
  expect(tabs()[0]).toHaveAttribute('aria-current', 'page')
  expect(tabs()[4]).not.toHaveAttribute('aria-current')
})

test('a page below a screen is marked as part of it', async () => {
  expect(screenOf(screensOf(PRODUCER), '/projects/p1/builds')?.label).toBe('Project')
  expect(screenOf(screensOf(PRODUCER), '/projects/p1/sound-list/compare')?.label).toBe('Sound list')
  expect(screenOf(screensOf(PRODUCER), '/studio')).toBeUndefined()
  await open(PRODUCER, '/projects/p1/builds')
  expect(tabs().map((tab) => tab.getAttribute('aria-current'))).toEqual([null, null, null, null, 'true'])
})

test('a designer has a Desk, Sound list and Project', async () => {
  await open(DESIGNER, '/desk')
  expect(tabs().map((tab) => tab.textContent)).toEqual(['Desk3 waiting', 'Sound list', 'Contract', 'Project'])
})

test('without a project there is one place to find one', () => {
  const paths = screensOf({ ...PRODUCER, project: null }).map(({ path }) => path)
  expect(paths).toEqual(['/today', '/projects'])
  expect(screensOf({ ...PRODUCER, person: null })).toEqual([])
})

test('g l goes to the list; the head takes the focus and the title follows', async () => {
  await open(PRODUCER)
  await waitFor(() => expect(document.title).toBe('Today · Shield Wing · Soundlist'))
  await userEvent.keyboard('gl')
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
  expect(tabs()).toHaveLength(5)
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

test('who only reviews has no tab for contracts', () => {
  const labels = (data: ShellData) => screensOf(data).map(({ label }) => label)
  expect(labels(PRODUCER)).toContain('Contract')
  expect(labels({ ...PRODUCER, isParty: false })).toEqual(['Today', 'Sound list', 'Review', 'Project'])
})
