import { useQuery } from '@tanstack/react-query'

import { type Me } from '@/api/me'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ago, day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import classes from './Account.module.css'
import { type SignIn, signInsQuery, signUpQuery, useAskVerification, useEndOtherSignIns, useEndSignIn } from './api'
import { CardProblem } from './CardProblem'
import { EmailChangeForm } from './EmailChangeForm'

/** The address, and whether it is verified. */
export function AddressCard({ me }: { me: Me }) {
  const asking = useAskVerification()
  const { data: way } = useQuery(signUpQuery)
  const isVerified = me.email_verified_at !== null
  return (
    <Card aria-labelledby="address-card">
      <CardHead id="address-card" title="Email" />
      <div className={classes.inside}>
        <p className="flex wrap between gap-2 pt-3 wrap-anywhere">
          <span className="strong">{me.email}</span>
          <StatusBadge kind={isVerified ? 'passed' : 'warning'}>{isVerified ? 'Verified' : 'Not verified'}</StatusBadge>
        </p>
        {!isVerified && way !== undefined && (
          <div className="grid gap-3 wrap-anywhere pt-3">
            <p className="mid">
              {way.by_mail
                ? 'Verify it before you sign a contract, so the other party knows who signed.'
                : 'You can sign contracts without it. Their record then shows that your email was not verified.'}
            </p>
            {!way.by_mail && (
              <p className="small mid">
                This server sends no email. Its administrator can read the link with{' '}
                <code>soundlist mails {me.email}</code> and pass it to you.
              </p>
            )}
            <CardProblem error={asking.error} />
            <div>
              <Button
                aria-busy={asking.isPending}
                onClick={() =>
                  asking.mutate(undefined, {
                    onSuccess: () =>
                      showToast(
                        way.by_mail
                          ? `We have sent a link to ${me.email}.`
                          : 'The link is ready. Ask the server’s administrator for it.',
                      ),
                  })
                }
              >
                {way.by_mail
                  ? asking.isSuccess
                    ? 'Send the link again'
                    : 'Send a verification link'
                  : asking.isSuccess
                    ? 'Create a new link'
                    : 'Create a verification link'}
              </Button>
            </div>
          </div>
        )}
        <EmailChangeForm email={me.email} />
      </div>
    </Card>
  )
}

/** Where one is signed in. */
export function SignInsCard() {
  const { data: signIns, error } = useQuery(signInsQuery)
  const end = useEndSignIn()
  const endOthers = useEndOtherSignIns()
  const others = signIns?.filter(({ is_current }) => !is_current) ?? []
  return (
    <Card aria-labelledby="sign-ins">
      <CardHead
        id="sign-ins"
        title="Active sessions"
        note="sessions end after 14 days without use, or 30 days in total"
      />
      <CardProblem error={error ?? end.error ?? endOthers.error} />
      <Rows aria-label="Active sessions">
        {signIns?.map((signIn) => (
          <SignInRow
            key={signIn.id}
            signIn={signIn}
            onEnd={() => end.mutate(signIn.id, { onSuccess: () => showToast('Signed out of that browser.') })}
          />
        ))}
      </Rows>
      {others.length > 1 && (
        <div className={`${classes.inside} ${classes.note}`}>
          <Button
            onClick={() =>
              endOthers.mutate(undefined, { onSuccess: () => showToast('Signed out of all other browsers.') })
            }
          >
            Sign out all others
          </Button>
        </div>
      )}
    </Card>
  )
}

function SignInRow({ signIn, onEnd }: { signIn: SignIn; onEnd: () => void }) {
  const { device, place, is_current, created_at, last_seen_at } = signIn
  const name = device || 'Unknown browser'
  return (
    <Row>
      <div className="grow">
        <p className="strong">{name}</p>
        <p className="small mid">
          {[place, `since ${day(created_at)}`, is_current ? '' : `last used ${ago(last_seen_at)}`]
            .filter(Boolean)
            .join(', ')}
        </p>
      </div>
      {is_current ? (
        <StatusBadge kind="passed">This browser</StatusBadge>
      ) : (
        <Button variant="quiet" aria-label={`Sign out ${name}, ${place}`} onClick={onEnd}>
          Sign out
        </Button>
      )}
    </Row>
  )
}
