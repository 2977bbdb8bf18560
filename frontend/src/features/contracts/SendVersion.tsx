import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useUnsent } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import { type Contract, useContractAction } from './api'
import classes from './Contracts.module.css'
import { Warning } from './Warning'

interface SendVersionProps {
  contract: Contract
  /** The contract’s page. */
  back: string
  /** What else can be done first, between the draft and the sending. */
  children?: ReactNode
}

/** The draft, and the button that sends its text to the designer. */
export function SendVersion({ contract, back, children }: SendVersionProps) {
  const send = useContractAction(contract.id)
  const text = `contract:${contract.id}` as const
  const unsaved = useUnsent([text, `plan:${contract.id}`])
  return (
    <>
      {unsaved !== null && (
        <Warning>
          {`${unsaved === text ? 'The draft' : 'The plan'} has changes that are not saved: save or discard them first. `}
          <ButtonLink component={Link} variant="quiet" to={`${back}/${unsaved === text ? 'draft' : 'plan'}`}>
            {unsaved === text ? 'Open the draft' : 'Open the plan'}
          </ButtonLink>
        </Warning>
      )}
      <Refusal error={send.error} />
      <div className={classes.buttons}>
        <ButtonLink component={Link} icon="pencil" to={`${back}/draft`}>
          Edit draft
        </ButtonLink>
        {children}
        <Button
          variant="primary"
          disabled={unsaved !== null}
          aria-busy={send.isPending}
          onClick={() =>
            send.mutate(
              { does: 'send', note: '' },
              { onSuccess: () => showToast(`${contract.title} sent. Both sides can sign it now.`) },
            )
          }
        >
          {`Send to ${contract.joint.length > 0 ? contract.joint.map(({ designer }) => designer.name).join(' and ') : contract.designer.name}`}
        </Button>
      </div>
    </>
  )
}
