import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'

import { useVerifyEmail } from './api'
import { Sheet } from '@/ui/Sheet'
import { PageSkeleton } from '@/ui/Skeleton'
import { CardProblem } from './CardProblem'

/** The page of the mailed link that verifies an address; a press, since mail filters open links by themselves. */
export function VerifyPage() {
  useTitle('Verify your email')
  const { secret } = useParams({ from: '/shell/verify-address/$secret' })
  const { data: me } = useQuery(meQuery)
  const verify = useVerifyEmail(secret)
  if (me === undefined) return <PageSkeleton />
  if (verify.isSuccess) {
    return (
      <Sheet>
        <h1>Email verified</h1>
        <p className="mid">{me.email} is verified. You can sign contracts with it.</p>
        <p style={{ marginTop: 'var(--sl-4)' }}>
          <Link className="link" to="/">
            Continue
          </Link>
        </p>
      </Sheet>
    )
  }
  return (
    <Sheet>
      <h1>Verify your email</h1>
      <p className="mid">You are signed in as {me.email}.</p>
      <CardProblem error={verify.error} />
      <div style={{ marginTop: 'var(--sl-4)' }}>
        <Button variant="primary" aria-busy={verify.isPending} onClick={() => verify.mutate()}>
          Verify {me.email}
        </Button>
      </div>
    </Sheet>
  )
}
