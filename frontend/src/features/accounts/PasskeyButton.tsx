import { refusalOf, sentence } from '@/app/Form'
import { Button } from '@/ui/Button'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Account.module.css'
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
  const refusal = refusalOf(signIn.error)
  return (
    <div className={`stack ${classes.passkey}`}>
      {signIn.error !== null && (
        <ProblemNote
          detail={
            isCancelled(signIn.error) ? 'No passkey was used.' : sentence(refusal?.detail ?? 'Can’t reach Soundlist.')
          }
          fix={refusal?.fix ? sentence(refusal.fix) : undefined}
        />
      )}
      <Button
        aria-busy={signIn.isPending}
        onClick={() => signIn.mutate(undefined, { onSuccess: ({ id }) => onSignedIn(id) })}
      >
        {action}
      </Button>
    </div>
  )
}
