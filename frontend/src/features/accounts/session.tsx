import { type QueryClient, useQuery, useQueryClient } from '@tanstack/react-query'
import { redirect, useParams, useRouter } from '@tanstack/react-router'
import { lazy, Suspense, useEffect } from 'react'

import { ApiProblem, resumeOutbox, leaveSession, post } from '@/api'
import { type Me, meQuery } from '@/api/me'
import { speaksFor } from '@/api/me'
import { cameBack, deskQuery } from '@/app/desk'
import { forgetDrafts, openDraftsOf } from '@/app/drafts'
import { followChanges } from '@/app/liveChanges'
import { keepLastProject, lastProject } from '@/app/lastProject'
import { badgesOf, nextStepsQuery } from '@/app/nextSteps'
import { unreadQuery, unreadWords } from '@/app/notices'
import { showToast } from '@/app/toast'
import { NOBODY, type Session, type ShellData } from '@/app/session'
import { countQuery } from '@/verdicts/api'
import { counted } from '@/verdicts/words'

import { sessionQuery } from './api'
import { partWord } from './parts'
import { SignInAgain } from './SignInAgain'

const DemoSwitch = lazy(async () => ({ default: (await import('./DemoSwitch')).DemoSwitch }))

/** Where a second factor is set up. */
const ACCOUNT = '/account'

const isSignedOut = (error: unknown): boolean => error instanceof ApiProblem && error.status === 401

/** The page to return to after signing in; omitted for the start page. */
const backTo = (href: string): { next?: string } => (href === '/' ? {} : { next: href })

async function signOut(client: QueryClient, leave: () => Promise<void>): Promise<void> {
  try {
    await post('/v1/sign-out')
  } catch (error) {
    if (!isSignedOut(error)) {
      showToast('Could not sign you out: the server can’t be reached.')
      return
    }
  }
  leaveSession()
  forgetDrafts()
  await leave()
  client.clear()
}

const projectIdsOf = (client: QueryClient): ReadonlySet<string> =>
  new Set(client.getQueryData<Me>(meQuery.queryKey)?.projects.map(({ id }) => id))

function useShell(): ShellData {
  const client = useQueryClient()
  const router = useRouter()
  const { data: session } = useQuery(sessionQuery)
  const { data: me, error } = useQuery(meQuery)
  const { projectId } = useParams({ strict: false })
  const currentId = projectId ?? lastProject()
  const project = me?.projects.find(({ id }) => id === currentId) ?? (projectId ? undefined : me?.projects[0])
  const isTeam = project?.part === 'team'
  const { data: review } = useQuery({ ...countQuery(project?.id ?? ''), enabled: isTeam })
  const { data: desk } = useQuery({
    ...deskQuery(project?.id ?? ''),
    enabled: project?.part === 'designer' && !project.nda_open,
  })
  const { data: next } = useQuery({ ...nextStepsQuery(project?.id ?? ''), enabled: project !== undefined })
  const badges = next && badgesOf(next)
  const { data: unread } = useQuery({ ...unreadQuery, enabled: me !== undefined })

  useEffect(() => {
    if (project && project.id === projectId) keepLastProject(project.id)
  }, [project, projectId])

  const signedOut = isSignedOut(error)
  useEffect(() => {
    if (!signedOut) return
    const href = router.state.location.href
    client.clear()
    void router.navigate({ to: '/sign-in', search: backTo(href) })
  }, [signedOut, client, router])

  const personId = me?.person.id
  useEffect(() => {
    if (personId !== undefined) resumeOutbox(personId, () => void client.invalidateQueries())
  }, [client, personId])
  useEffect(
    () => (personId === undefined ? undefined : followChanges(client, personId, () => projectIdsOf(client))),
    [personId, client],
  )

  if (me === undefined) return NOBODY
  const isDemo = session?.demo === true
  const roles = (me.studios.find(({ id }) => id === project?.studio_id) ?? me.studios[0])?.roles ?? []
  return {
    person: { name: me.person.name, role: partWord(me, project), picture: me.person.picture },
    side: project ? (isTeam ? 'studio' : 'designer') : me.studios.length > 0 ? 'studio' : 'designer',
    project: project ? { id: project.id, name: project.name, isSample: project.is_sample } : null,
    ndaOpen: project?.nda_open ?? false,
    speaks: speaksFor(project),
    hasContracts: me.has_contracts !== false,
    isProducer: project ? project.is_producer : roles.includes('producer'),
    isImplementer: project?.is_approver !== true && roles.length > 0 && roles.every((role) => role === 'implementer'),
    projects: me.projects.map(({ id, name }) => ({ id, name })),
    counts: {
      review: review && counted(review),
      desk: desk && cameBack(desk) + desk.unmatched,
      today: badges?.today,
      contract: badges?.contract,
    },
    unread: unreadWords(unread),
    operates: me.is_operator || me.studios.some(({ roles }) => roles.includes('producer')),
    signOut: () => void signOut(client, () => router.navigate({ to: '/sign-in', search: {} })),
    signInAgain: isDemo ? undefined : <SignInAgain me={me} />,
    switcher: isDemo ? (
      <Suspense fallback={null}>
        <DemoSwitch projectId={project?.id} />
      </Suspense>
    ) : undefined,
  }
}

/** The current person: requested from the server once a minute at most, and before every page of the shell. */
export function createSession(client: QueryClient): Session {
  return {
    useShell,
    prefetchPerson: () => {
      void client.prefetchQuery(sessionQuery)
      void client.prefetchQuery(meQuery) // nearly always someone is
    },
    ensureSignedIn: async (href) => {
      const session = await client.ensureQueryData(sessionQuery)
      if (!session.signed_in) {
        client.removeQueries({ queryKey: sessionQuery.queryKey })
        throw redirect({ to: '/sign-in', search: backTo(href) })
      }
      try {
        const me = await client.ensureQueryData(meQuery)
        openDraftsOf(me.person.id)
        if (me.second_factor_required_by?.length && !href.startsWith(ACCOUNT)) throw redirect({ to: ACCOUNT })
      } catch (error) {
        if (!isSignedOut(error)) throw error
        client.clear()
        throw redirect({ to: '/sign-in', search: backTo(href) })
      }
    },
  }
}
