import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'

import { linkQuery, useJoin, visitorQuery } from './api'
import classes from './Hiring.module.css'
import { PostingFacts } from './PostingFacts'
import { Refusal } from './Refusal'

/** What the link of a posting shows, before any account; bidding needs one. */
export function PostingLinkPage() {
  useTitle('Posting')
  const { secret } = useParams({ from: '/guest/posting/$secret' })
  const { data: posting, error } = useQuery(linkQuery(secret))
  const { data: visitor } = useQuery(visitorQuery)
  const navigate = useNavigate()
  const join = useJoin(secret)
  if (error) {
    return (
      <div className={`page stack ${classes.sheet}`}>
        <h1>Posting</h1>
        <Refusal error={error} />
      </div>
    )
  }
  if (posting === undefined) return <div className="page" aria-busy="true" />
  const begin = () =>
    join.mutate(undefined, {
      onSuccess: ({ posting_id: postingId }) => void navigate({ to: '/postings/$postingId', params: { postingId } }),
    })
  return (
    <div className={`page stack ${classes.sheet}`}>
      <PostingFacts posting={posting} ndaOpen={posting.nda_needed} />
      <Refusal error={join.error} />
      {visitor ? (
        <div>
          <Button variant="primary" aria-busy={join.isPending} onClick={begin}>
            {posting.takes_bids ? 'Bid on this' : 'Open'}
          </Button>
        </div>
      ) : (
        <p>
          You need an account only to bid.{' '}
          <Link className="link" to="/sign-in" search={{ next: `/posting/${secret}` }}>
            Sign in
          </Link>{' '}
          or{' '}
          <Link className="link" to="/sign-up">
            create an account
          </Link>
          , then open this link again.
        </p>
      )}
    </div>
  )
}
