import { useInfiniteQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect, useEffectEvent, useState } from 'react'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'

import type { CameBack, Desk, ToMake } from './api'

interface PageOf<T> {
  items: T[]
  next?: string | null
}
type Read<T> = (projectId: string, cursor: string | undefined) => Promise<PageOf<T>>

/** A list of the desk as far as it was asked for. */
export interface DeskList<T> {
  items: readonly T[]
  hasMore: boolean
  isFetching: boolean
  showMore: () => void
}

const READS = {
  came_back: (projectId: string, cursor?: string) =>
    get('/v1/projects/{project_id}/desk/came-back', { project_id: projectId, cursor }),
  to_make: (projectId: string, cursor?: string) =>
    get('/v1/projects/{project_id}/desk/to-make', { project_id: projectId, cursor }),
  with_approver: (projectId: string, cursor?: string) =>
    get('/v1/projects/{project_id}/desk/with-approver', { project_id: projectId, cursor }),
}

/** The first page comes with the desk; once more is asked for, the list is read page by page. */
function usePages<T>(list: keyof typeof READS, projectId: string, items: T[], next: string | null): DeskList<T> {
  const client = useQueryClient()
  const [isOpened, setOpened] = useState(false)
  const read = READS[list] as unknown as Read<T>
  const queryKey = queryKeys.desk(projectId, list)
  const { data, refetch, fetchNextPage, hasNextPage, isFetchingNextPage } = useInfiniteQuery({
    queryKey,
    queryFn: ({ pageParam: cursor }) => read(projectId, cursor),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next: following }) => following ?? undefined,
    enabled: isOpened,
  })
  const readAnew = useEffectEvent(() => {
    if (isOpened) void refetch()
  })
  // Counts refreshed by the first page hold for the others too.
  useEffect(() => {
    readAnew()
  }, [items, next])
  if (!isOpened || data === undefined) {
    const showMore = () => {
      client.setQueryData(queryKey, { pages: [{ items, next }], pageParams: [undefined] })
      setOpened(true)
      void fetchNextPage()
    }
    return { items, hasMore: Boolean(next), isFetching: isFetchingNextPage, showMore }
  }
  return {
    items: data.pages.flatMap((page) => page.items),
    hasMore: hasNextPage,
    isFetching: isFetchingNextPage,
    showMore: () => void fetchNextPage(),
  }
}

export const useCameBack = (projectId: string, desk: Desk): DeskList<CameBack> =>
  usePages('came_back', projectId, desk.came_back, desk.came_back_next)

export const useToMake = (projectId: string, desk: Desk): DeskList<ToMake> =>
  usePages('to_make', projectId, desk.to_make, desk.to_make_next)

export const useWithApprover = (projectId: string, desk: Desk): DeskList<Desk['with_approver'][number]> =>
  usePages('with_approver', projectId, desk.with_approver, desk.with_approver_next)
