import { Outlet, useLocation, useRouter } from '@tanstack/react-router'
import { useCallback, useState } from 'react'

import { isMac } from '@/ui/keyNames'

import { useFirstInteraction } from '../firstInteraction'
import { useHotkeys } from '../keys'
import { LazyDialog } from '../LazyDialog'
import { useCommands } from '../palette'
import { SampleBanner } from '../SampleProject'
import type { Session } from '../session'
import { preloadPages } from '../prefetchPage'
import { ProjectName } from '../title'
import { OfflineBanner } from './OfflineBanner'
import { Main } from './Main'
import { isClosed, NdaFirst } from './NdaFirst'
import { loadKeysSheet, loadPalette } from './overlays'
import { useScheme } from './scheme'
import { areasOf } from './areas'
import { TopBar } from './TopBar'
import { useFinding } from './useFinding'

/** The frame of every page for people who are signed in. */
export function Shell({ session }: { session: Session }) {
  const data = session.useShell()
  const router = useRouter()
  const { pathname } = useLocation()
  const [finding, setFinding] = useState(false)
  const [showingKeys, setShowingKeys] = useState(false)
  const { next: nextScheme, set: setScheme } = useScheme()

  const areas = areasOf(data)
  const inBar = areas.filter(({ isInMenu }) => !isInMenu)
  const likely = inBar.flatMap(({ path, count }) => (count ? [path] : [])).join('\n')
  useFirstInteraction(useCallback(() => preloadPages(router, likely.split('\n').filter(Boolean)), [router, likely]))
  const go = (path: string) => void router.navigate({ href: path })
  useFinding(data.project?.id, data.side === 'designer', go)

  useHotkeys([
    { keys: 'mod+k', label: 'Search or run a command', group: 'Everywhere', run: () => setFinding(true) },
    { keys: '?', label: 'Keyboard shortcuts', group: 'Everywhere', run: () => setShowingKeys(true) },
    ...(data.person ? [{ keys: 'g n', label: 'Go to Notices', group: 'Everywhere', run: () => go('/notices') }] : []),
    ...inBar.map(({ label, path, letter }) => ({
      keys: `g ${letter}`,
      label: `Go to ${label}`,
      group: 'Everywhere',
      run: () => go(path),
    })),
  ])
  useCommands([
    ...areas.flatMap(({ label: area, letter, icon, pages }) =>
      pages.map(({ label, path, also }, index) => ({
        id: `page-${path}`,
        label: index === 0 && letter ? `Go to ${area}` : label,
        icon,
        keys: index === 0 && letter ? `g ${letter}` : path === '/notices' ? 'g n' : undefined,
        also: index === 0 ? [label, ...also] : [...also],
        run: () => go(path),
      })),
    ),
    ...data.projects
      .filter(({ id }) => id !== data.project?.id)
      .map(({ id, name }) => ({
        id: `project-${id}`,
        label: `Open ${name}`,
        icon: 'box' as const,
        also: ['project'],
        run: () => go(`/projects/${id}`),
      })),
    {
      id: 'scheme',
      label: `Switch to ${nextScheme}`,
      icon: nextScheme === 'dark' ? 'moon' : 'sun',
      also: ['theme', 'colours'],
      run: () => setScheme(nextScheme),
    },
    { id: 'keys', label: 'Show keyboard shortcuts', icon: 'question', keys: '?', run: () => setShowingKeys(true) },
  ])

  return (
    <ProjectName value={data.project?.name}>
      <TopBar
        data={data}
        areas={areas}
        pathname={pathname}
        findKeys={isMac() ? '⌘ K' : 'Ctrl K'}
        onFind={() => setFinding(true)}
        onKeys={() => setShowingKeys(true)}
      />
      <OfflineBanner />
      {data.project?.isSample && pathname.startsWith(`/projects/${data.project.id}`) && (
        <SampleBanner projectId={data.project.id} isProducer={data.isProducer} />
      )}
      <Main>
        {data.project && data.ndaOpen && isClosed(pathname, data.project.id) ? (
          <NdaFirst projectId={data.project.id} go={go} />
        ) : (
          <Outlet />
        )}
      </Main>
      <LazyDialog load={loadPalette} opened={finding} onClose={() => setFinding(false)} given={{}} />
      {data.signInAgain}
      <LazyDialog load={loadKeysSheet} opened={showingKeys} onClose={() => setShowingKeys(false)} given={{}} />
    </ProjectName>
  )
}
