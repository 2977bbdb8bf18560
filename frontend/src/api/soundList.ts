import { type QueryClient, queryOptions } from '@tanstack/react-query'

import { get } from './endpoint'
import { everyPage } from './pages'
import { queryKeys } from './queryKeys'
import type { components } from './schema.gen'

type Cue = components['schemas']['CueRead']

/** Cues a page after the first one, which comes with the server's own, shorter length. */
export const CUES_A_PAGE = 500

/** Read every page; while nothing was here before, what has come is shown already. */
export async function readAll<P extends { next: string | null }, T>(
  client: QueryClient,
  queryKey: readonly unknown[],
  read: (page: { cursor?: string; limit?: number }) => Promise<P>,
  joined: (pages: readonly P[]) => T,
): Promise<T> {
  const isNew = client.getQueryData(queryKey) === undefined
  const pages = await everyPage(
    (cursor) => read(cursor === undefined ? {} : { cursor, limit: CUES_A_PAGE }),
    (sofar) => {
      if (isNew) client.setQueryData(queryKey, joined(sofar))
    },
  )
  return joined(pages)
}

/** The sound list; `isComplete` is false while later pages are still on their way. */
export const listQuery = (projectId: string) =>
  queryOptions({
    queryKey: queryKeys.soundList(projectId, 'list'),
    queryFn: ({ client, queryKey }) =>
      readAll(
        client,
        queryKey,
        (page) => get('/v1/projects/{project_id}/sound-list', { project_id: projectId, ...page }),
        (pages) => ({
          revision: pages[0]?.revision ?? 0,
          cues: pages.flatMap(({ cues }) => cues),
          isComplete: (pages.at(-1)?.next ?? null) === null,
        }),
      ),
  })

interface List {
  cues: Cue[]
  isComplete: boolean
}
const cuesOf = ({ cues, isComplete }: List) => (isComplete ? cues : undefined)
const keptOf = ({ cues, isComplete }: List) => (isComplete ? cues.filter(({ state }) => state !== 'cut') : undefined)

/** Every cue of the list, cut ones too, once all of them have come. */
export const cuesQuery = (projectId: string) => queryOptions({ ...listQuery(projectId), select: cuesOf })

/** The cues of the list that are not cut, in its order, once all of them have come. */
export const keptCuesQuery = (projectId: string) => queryOptions({ ...listQuery(projectId), select: keptOf })
