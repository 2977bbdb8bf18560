import { useQuery } from '@tanstack/react-query'

import { queryKeys } from './queryKeys'
import { useMutation } from './useMutation'

const LOOK_MS = 500

/** What a worker makes when it is asked for, or says why it does not. */
interface Made {
  id: string
  state: 'making' | 'made' | 'refused'
}

/** Ask for something that a worker makes; it is read again until it is made or refused. */
export function useAsyncJob<Wanted, T extends Made>(
  kind: string,
  askFor: (request: Wanted) => Promise<T>,
  read: (id: string) => Promise<T>,
) {
  const ask = useMutation({ mutationFn: askFor })
  const asked = ask.data
  const now = useQuery({
    queryKey: queryKeys.made(kind, asked?.id, ask.submittedAt),
    queryFn: () => read(asked?.id ?? ''),
    enabled: asked?.state === 'making',
    refetchInterval: ({ state: { data } }) => (data === undefined || data.state === 'making' ? LOOK_MS : false),
  })
  const made = asked?.state === 'making' ? (now.data ?? asked) : asked
  return { ask, made, making: ask.isPending || made?.state === 'making', error: ask.error ?? now.error }
}
