import { useQuery } from '@tanstack/react-query'
import { Link, useNavigate, useParams } from '@tanstack/react-router'

import { visitorQuery } from '@/api/me'
import { formDraft } from '@/app/drafts'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { PageSkeleton } from '@/ui/Skeleton'

import { linkQuery, useAskForLink, useJoin, useOpenAccount } from './api'
import classes from './Hiring.module.css'
import { PostingFacts } from './PostingFacts'

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
  if (posting === undefined) return <PageSkeleton />
  const begin = () =>
    join.mutate(undefined, {
      onSuccess: ({ posting_id: postingId }) => void navigate({ to: '/postings/$postingId', params: { postingId } }),
    })
  return (
    <div className={`page stack ${classes.sheet}`}>
      <PostingFacts posting={posting} ndaOpen={posting.nda_needed} />
      <Refusal error={join.error} />
      {visitor && (
        <div>
          <Button variant="primary" aria-busy={join.isPending} onClick={begin}>
            {posting.takes_bids ? 'Bid on this' : 'Open'}
          </Button>
        </div>
      )}
      {visitor === null && posting.email !== null && (
        <AccountCard secret={secret} email={posting.email} hasAccount={posting.has_account} onSignedIn={begin} />
      )}
      {visitor === null && posting.email === null && posting.takes_bids && (
        <AskCard secret={secret} sendsMail={posting.sends_mail} />
      )}
    </div>
  )
}

interface AccountCardProps {
  secret: string
  email: string
  hasAccount: boolean
  onSignedIn: () => void
}

/** A personal link: it was mailed to its address, so a name and a password are enough to bid. */
function AccountCard({ secret, email, hasAccount, onSignedIn }: AccountCardProps) {
  const open = useOpenAccount(secret)
  return (
    <Card aria-labelledby="account">
      <CardHead id="account" title={hasAccount ? 'Sign in to bid' : 'Create an account to bid'} />
      <div className={`grid gap-3 ${classes.body}`}>
        <p className="mid">
          {hasAccount ? `${email} already has an account.` : `For ${email}. The studio sees your name with your bid.`}
        </p>
        <Form
          {...formDraft(`posting-account:${secret}`, { name: '', password: '' })}
          mutation={open}
          onSubmit={({ name, password }) =>
            open.mutate({ name: hasAccount ? null : name, password }, { onSuccess: onSignedIn })
          }
        >
          {!hasAccount && <Field name="name" label="Your name" autoComplete="name" />}
          <input type="hidden" name="username" autoComplete="username" value={email} />
          <Field
            name="password"
            label={hasAccount ? 'Password' : 'New password'}
            type="password"
            autoComplete={hasAccount ? 'current-password' : 'new-password'}
            description={hasAccount ? undefined : 'At least 10 characters. Four unrelated words make a good password.'}
          />
          <Submit>{hasAccount ? 'Sign in and bid' : 'Create account and bid'}</Submit>
        </Form>
      </div>
    </Card>
  )
}

/** The link for everyone: it proves no address, so a link of one's own comes by email first. */
function AskCard({ secret, sendsMail }: { secret: string; sendsMail: boolean }) {
  const ask = useAskForLink(secret)
  return (
    <Card aria-labelledby="ask">
      <CardHead
        id="ask"
        title={ask.isSuccess ? (sendsMail ? 'Check your inbox' : 'The studio has your address') : 'Bid on this'}
      />
      <div className={`grid gap-3 ${classes.body}`}>
        {ask.isSuccess ? (
          <p role="status">
            {sendsMail
              ? `We have sent an email to ${ask.variables} with a link of your own. It opens this page, where you can bid. `
              : `This server sends no email: the studio hands you a link for ${ask.variables}, which opens this page. `}
            <button type="button" className="link" onClick={() => ask.reset()}>
              {sendsMail ? 'Use another email, or send it again' : 'Use another email'}
            </button>
          </p>
        ) : (
          <>
            <p className="mid">
              {sendsMail
                ? 'You get a link of your own by email, and bid by it.'
                : 'You bid by a link of your own. This server sends no email: the studio hands it to you.'}
            </p>
            <Form
              {...formDraft(`posting-ask:${secret}`, { email: '' })}
              mutation={ask}
              onSubmit={({ email }) => ask.mutate(email)}
            >
              <Field name="email" label="Email" type="email" autoComplete="email" />
              <Submit
                beside={
                  <Link className="link small mid" to="/sign-in" search={{ next: `/posting/${secret}` }}>
                    I already have an account
                  </Link>
                }
              >
                {sendsMail ? 'Email me a link' : 'Ask for a link'}
              </Submit>
            </Form>
          </>
        )}
      </div>
    </Card>
  )
}
