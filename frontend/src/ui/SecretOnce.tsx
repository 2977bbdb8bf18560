import type { ReactNode } from 'react'

import { Button } from './Button'
import { CopyButton } from './CopyButton'

interface SecretOnceProps {
  secret: string
  /** What it is, said when it was copied: "Token". */
  what: string
  /** Where several are made: the name of this one. */
  name?: string
  /** What it is for, and what to do when it is lost. */
  children: ReactNode
  onDone: () => void
}

/** A secret that is shown this once, until the person says that they have saved it. */
export function SecretOnce({ secret, what, name, children, onDone }: SecretOnceProps) {
  return (
    <div className="grid gap-2" role="status">
      <p>
        <span className="strong">{`Copy the secret${name === undefined ? '' : ` of “${name}”`} now. It is not shown again.`}</span>{' '}
        <span className="mid">{children}</span>
      </p>
      <code className="mono wrap-anywhere">{secret}</code>
      <div className="row wrap">
        <CopyButton text={secret} what={what}>
          Copy secret
        </CopyButton>
        <Button variant="quiet" onClick={onDone}>
          I’ve saved it
        </Button>
      </div>
    </div>
  )
}
