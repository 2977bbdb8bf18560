import { type QueryClient, queryOptions, useQuery, useQueryClient } from '@tanstack/react-query'
import { useEffect } from 'react'

import { unwrap } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { finePeaks, type Peaks } from '@/audio'

import type { ReviewTake } from './api'

async function readPeaks(url: string): Promise<Peaks> {
  const read = await unwrap<components['schemas']['PeaksRead']>(
    fetch(url, { credentials: 'same-origin' }).then(async (response) => ({
      response,
      data: response.ok ? ((await response.json()) as components['schemas']['PeaksRead']) : undefined,
    })),
  )
  return finePeaks(read)
}

const peaksQuery = (url: string) =>
  queryOptions({ queryKey: queryKeys.peaks(url), queryFn: () => readPeaks(url), staleTime: Infinity })

export const prefetchPeaks = (client: QueryClient, url: string) => client.prefetchQuery(peaksQuery(url))

/** The fine shape of one sound: undefined while it is on its way, null where the server has none. */
export function usePeaks(url: string | null | undefined): Peaks | null | undefined {
  const { data, isError } = useQuery({ ...peaksQuery(url ?? ''), enabled: Boolean(url) })
  if (url === undefined) return undefined
  return url === null || isError ? null : data
}

/** Have the shapes of what comes next here, once what is shown has its own. */
export function usePeaksAhead(shown: string | null | undefined, next: readonly ReviewTake[]): void {
  const client = useQueryClient()
  const isShown = usePeaks(shown) !== undefined
  const urls = next.flatMap(({ peaks_url }) => peaks_url ?? []).join('\n')
  useEffect(() => {
    if (isShown) for (const url of urls.split('\n').filter(Boolean)) void prefetchPeaks(client, url)
  }, [client, isShown, urls])
}
