import {
  type QueryKey,
  type UseMutateFunction,
  useMutation as useQuietMutation,
  type UseMutationOptions,
  type UseMutationResult,
  useQueryClient,
} from '@tanstack/react-query'
import { useCallback } from 'react'

import { invalidate } from './queryKeys'

type Options<TData, TError, TVariables, TContext> = UseMutationOptions<TData, TError, TVariables, TContext> & {
  /** The keys of what it changes; they are refetched once it has succeeded. */
  affects?: readonly QueryKey[]
}

/**
 * A mutation that calls the handlers given to `mutate` even where the part of the page that asked has gone. The
 * server's events often take it away before the answer is here: its toast would never show, and a text that was sent
 * would come back as typed.
 */
export function useMutation<TData = unknown, TError = Error, TVariables = void, TContext = unknown>({
  affects,
  ...options
}: Options<TData, TError, TVariables, TContext>): UseMutationResult<TData, TError, TVariables, TContext> {
  const client = useQueryClient()
  const mutation = useQuietMutation(affects ? { ...options, onSuccess: () => invalidate(client, ...affects) } : options)
  const { mutateAsync } = mutation
  const mutate = useCallback<UseMutateFunction<TData, TError, TVariables, TContext>>(
    (...[variables, handlers]) => {
      const asked = variables as TVariables
      mutateAsync(asked).then(
        (data) => handlers?.onSuccess?.(data, asked, undefined, { client, meta: undefined }),
        (error: TError) => handlers?.onError?.(error, asked, undefined, { client, meta: undefined }),
      )
    },
    [client, mutateAsync],
  )
  return { ...mutation, mutate }
}
