import { SecretOnce } from '@/ui/SecretOnce'

import type { WebhookSecret } from './api'

/** A secret, which is shown this once. */
export function SecretNote({ webhook: { secret }, onDone }: { webhook: WebhookSecret; onDone: () => void }) {
  return (
    <SecretOnce secret={secret} what="Secret" onDone={onDone}>
      Your program checks the signature of each message with it; a chat needs none.
    </SecretOnce>
  )
}
