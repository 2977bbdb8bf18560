import { Button } from '@/ui/Button'
import { CopyButton } from '@/ui/CopyButton'

import type { WebhookSecret } from './api'
import classes from './Webhooks.module.css'

/** A secret, which is shown this once. */
export function SecretNote({ webhook: { secret }, onDone }: { webhook: WebhookSecret; onDone: () => void }) {
  return (
    <div className={classes.secretNote} role="status">
      <p>
        <span className="strong">Copy the secret now. It is not shown again.</span>{' '}
        <span className="mid">Your program checks the signature of each message with it; a chat needs none.</span>
      </p>
      <div className={classes.secret}>
        <code className="mono">{secret}</code>
        <CopyButton text={secret} what="Secret" variant="quiet" square aria-label="Copy secret" />
      </div>
      <div>
        <Button onClick={onDone}>I’ve saved it</Button>
      </div>
    </div>
  )
}
