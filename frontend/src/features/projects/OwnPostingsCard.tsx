import { queryOptions, useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { get } from '@/api'
import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { Card, CardHead } from '@/ui/Card'
import { day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

type PostingSummary = components['schemas']['PostingSummary']

const ownPostingsQuery = queryOptions({
  queryKey: queryKeys.ownPostings(),
  queryFn: () => get('/v1/postings'),
})

/** The postings that the current person may bid on, for a designer without a project too. */
export function OwnPostingsCard() {
  const { data: postings } = useQuery(ownPostingsQuery)
  if (postings === undefined || postings.length === 0) return null
  return (
    <Card aria-labelledby="own-postings">
      <CardHead id="own-postings" title="Postings for you" count={postings.length} />
      <Rows>
        {postings.map((posting) => (
          <Row key={posting.id}>
            <Link className="link grow cut-text" to="/postings/$postingId" params={{ postingId: posting.id }}>
              {posting.title}
            </Link>
            <span className="small mid">{posting.studio_name}</span>
            <span className="small mid">{standOf(posting)}</span>
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

function standOf({ state, takes_bids: takesBids, bids_until_on: until, own_bid: own }: PostingSummary): string {
  if (state === 'awarded') return 'awarded'
  if (own === 'sent') return 'your bid is sent'
  if (!takesBids) return 'takes no bids now'
  return until ? `bid until ${day(until)}` : 'takes bids'
}
