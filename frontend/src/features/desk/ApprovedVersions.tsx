import { useInfiniteQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import { variationName } from '@/verdicts/hearing'
import { reasonsText } from '@/verdicts/words'
import { Refusal } from '@/ui/Refusal'

const PAGE = 10

/** The designer's approved versions, and why each was chosen; the newest first. */
export function ApprovedVersions({ projectId }: { projectId: string }) {
  const { data, error, hasNextPage, isFetching, fetchNextPage } = useInfiniteQuery({
    queryKey: queryKeys.desk(projectId, 'approved'),
    queryFn: ({ pageParam: cursor }) =>
      get('/v1/projects/{project_id}/takes', { project_id: projectId, state: ['approved'], cursor, limit: PAGE }),
    initialPageParam: undefined as string | undefined,
    getNextPageParam: ({ next }) => next ?? undefined,
  })
  const takes = data?.pages.flatMap(({ items }) => items) ?? []
  return (
    <>
      <Refusal error={error} />
      {data && takes.length === 0 && <p className="mid p-10px-inset">No version of yours is approved yet.</p>}
      <ul aria-label="Approved versions" aria-busy={isFetching}>
        {takes.map(({ id, cue, file_name, variation, number, label, verdict_reasons: reasons }) => (
          <li key={id} className="p-2-inset border-t wrap-anywhere">
            <p>
              <Link className="link strong" to="/takes/$takeId" params={{ takeId: id }}>
                {cue?.name ?? file_name}
                {variation > 1 && variationName(variation)}
              </Link>{' '}
              <span className="small dim">
                version {number}
                {label !== null && `, ${label}`}
              </span>
            </p>
            {reasons.length > 0 && <p className="small mid">{reasonsText(reasons)}</p>}
          </li>
        ))}
      </ul>
      {hasNextPage && (
        <p className="p-10px-inset">
          <button type="button" className="link small mid" aria-busy={isFetching} onClick={() => void fetchNextPage()}>
            More approved versions
          </button>
        </p>
      )}
    </>
  )
}
