import { Outlet, useLocation, useRouter } from '@tanstack/react-router'
import { useCallback, useState } from 'react'

import { isMac } from '@/ui/keyNames'

import { useFirstSign } from '../firstSign'
import { useHotkeys } from '../keys'
import { LazyDialog } from '../LazyDialog'
import { useCommands } from '../palette'
import type { Session } from '../session'
import { loadAhead } from '../startEarly'
import { ProjectName } from '../title'
import { AwayNote } from './AwayNote'
import { Main } from './Main'
import { isClosed, NdaFirst } from './NdaFirst'
import { loadKeysSheet, loadPalette } from './overlays'
import { useScheme } from './scheme'
import { placesOf, screensOf } from './screens'
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

  const screens = screensOf(data)
  const likely = screens.flatMap(({ path, count }) => (count ? [path] : [])).join('\n')
  useFirstSign(useCallback(() => loadAhead(router, likely.split('\n').filter(Boolean)), [router, likely]))
  const go = (path: string) => void router.navigate({ href: path })
  useFinding(data.project?.id, data.side === 'designer', go)

  useHotkeys([
    { keys: 'mod+k', label: 'Search or run a command', group: 'Everywhere', run: () => setFinding(true) },
    { keys: '?', label: 'Keyboard shortcuts', group: 'Everywhere', run: () => setShowingKeys(true) },
    ...(data.person ? [{ keys: 'g n', label: 'Go to Notices', group: 'Everywhere', run: () => go('/notices') }] : []),
    ...screens.map(({ label, path, letter }) => ({
      keys: `g ${letter}`,
      label: `Go to ${label}`,
      group: 'Everywhere',
      run: () => go(path),
    })),
  ])
  useCommands([
    ...screens.map(({ label, path, letter, icon }) => ({
      id: `go-${letter}`,
      label: `Go to ${label}`,
      icon,
      keys: `g ${letter}`,
      run: () => go(path),
    })),
    ...(data.person
      ? [
          {
            id: 'place-/notices',
            label: 'Notices',
            icon: 'bell' as const,
            keys: 'g n',
            also: ['news', 'mentions', 'unread'],
            run: () => go('/notices'),
          },
        ]
      : []),
    ...placesOf(data).map(({ label, path, also }) => ({
      id: `place-${path}`,
      label,
      icon: 'right' as const,
      also,
      run: () => go(path),
    })),
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
        screens={screens}
        findKeys={isMac() ? '⌘ K' : 'Ctrl K'}
        onFind={() => setFinding(true)}
        onKeys={() => setShowingKeys(true)}
      />
      <AwayNote />
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
