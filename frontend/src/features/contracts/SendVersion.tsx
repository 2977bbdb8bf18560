import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'

import { type Contract, useDeed } from './api'
import classes from './Contracts.module.css'
import { Refusal } from './Refusal'

interface SendVersionProps {
  contract: Contract
  /** The contract’s page. */
  back: string
  /** What else can be done first, between the draft and the sending. */
  children?: ReactNode
}

/** The draft, and the button that sends its text to the designer. */
export function SendVersion({ contract, back, children }: SendVersionProps) {
  const send = useDeed(contract.id)
  return (
    <>
      <Refusal error={send.error} />
      <div className={classes.buttons}>
        <ButtonLink component={Link} icon="pencil" to={`${back}/draft`}>
          Edit draft
        </ButtonLink>
        {children}
        <Button
          variant="primary"
          aria-busy={send.isPending}
          onClick={() =>
            send.mutate(
              { does: 'send', note: '' },
              { onSuccess: () => showToast(`${contract.title} sent. Both sides can sign it now.`) },
            )
          }
        >
          {`Send to ${contract.designer.name}`}
        </Button>
      </div>
    </>
  )
}
