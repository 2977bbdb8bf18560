import { type QueryKey, useQueries, type UseQueryOptions } from '@tanstack/react-query'

/** Whether each of the queries was answered or refused once. They start together, so that a page is drawn in one go. */
export const useSettled = (queries: readonly Pick<UseQueryOptions<never, Error, unknown, QueryKey>, 'queryKey'>[]) =>
  useQueries({
    queries,
    combine: (results) => results.every(({ isPending }) => !isPending),
  })
