import { Button } from '@/ui/Button'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Refusal } from '@/ui/Refusal'

import { hasPasskeys, isCancelled, usePasskeySignIn } from './passkeyApi'

interface PasskeyButtonProps {
  /** A verb: "Sign in with a passkey". */
  action: string
  onSignedIn: (personId: string) => void
}

/** Signs in with a passkey, where the browser has any. */
export function PasskeyButton({ action, onSignedIn }: PasskeyButtonProps) {
  const signIn = usePasskeySignIn()
  if (!hasPasskeys()) return null
  return (
    <div className="stack justify-items-start mt-4">
      {isCancelled(signIn.error) ? <ErrorBanner detail="No passkey was used." /> : <Refusal error={signIn.error} />}
      <Button
        aria-busy={signIn.isPending}
        onClick={() => signIn.mutate(undefined, { onSuccess: ({ id }) => onSignedIn(id) })}
      >
        {action}
      </Button>
    </div>
  )
}
