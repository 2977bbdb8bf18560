import { useQuery } from '@tanstack/react-query'

import { answered } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { finePeaks, type Peaks } from '@/audio'

async function readPeaks(url: string): Promise<Peaks> {
  const read = await answered<components['schemas']['PeaksRead']>(
    fetch(url, { credentials: 'same-origin' }).then(async (response) => ({
      response,
      data: response.ok ? ((await response.json()) as components['schemas']['PeaksRead']) : undefined,
    })),
  )
  return finePeaks(read)
}

/** The fine shape of one sound: undefined while it is on its way, null where the server has none. */
export function usePeaks(url: string | null | undefined): Peaks | null | undefined {
  const { data, isError } = useQuery({
    queryKey: queryKeys.peaks(url ?? ''),
    queryFn: () => readPeaks(url ?? ''),
    enabled: Boolean(url),
    staleTime: Infinity,
  })
  if (url === undefined) return undefined
  return url === null || isError ? null : data
}
