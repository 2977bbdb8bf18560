import { useId, useState } from 'react'

import { ReasonForm } from '@/app/ReasonForm'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { type ChangeOffer, type ChangeOrders, useChangeOrder } from './api'
import classes from './Contracts.module.css'

interface OffersCardProps {
  all: ChangeOrders
  /** Begin a change order that says what changed. */
  onPropose: (offer: ChangeOffer) => void
}

/** What changed since both signed and no change order says yet: propose one, or dismiss it with a reason. */
export function OffersCard({ all, onPropose }: OffersCardProps) {
  if (all.offers.length === 0) return null
  return (
    <Card aria-labelledby="offers">
      <CardHead id="offers" title="Something changed since you signed" note="nothing is charged unless both sign" />
      <Rows aria-label="What changed since you signed">
        {all.offers.map((offer) => (
          <Offer key={offer.offer} offer={offer} contractId={all.contract_id} onPropose={onPropose} />
        ))}
      </Rows>
    </Card>
  )
}

interface OfferProps {
  offer: ChangeOffer
  contractId: string
  onPropose: (offer: ChangeOffer) => void
}

function Offer({ offer, contractId, onPropose }: OfferProps) {
  const [isDismissing, setIsDismissing] = useState(false)
  const id = useId()
  const { dismissed } = offer
  return (
    <Row className={classes.offer}>
      <p id={id}>{offer.text}</p>
      <p className="small mid">{offer.who === '' ? day(offer.at) : `${offer.who}, ${day(offer.at)}`}</p>
      {dismissed && (
        <p className="small mid">
          {`${dismissed.by}, for the ${dismissed.party}, wants no change order for it, ${day(dismissed.at)}: ${dismissed.reason}`}
        </p>
      )}
      <div className={classes.buttons}>
        <Button aria-describedby={id} onClick={() => onPropose(offer)}>
          Propose a change order
        </Button>
        <Button
          variant="quiet"
          aria-describedby={id}
          aria-expanded={isDismissing}
          onClick={() => setIsDismissing(!isDismissing)}
        >
          Dismiss
        </Button>
      </div>
      {isDismissing && <Dismiss offer={offer} contractId={contractId} />}
    </Row>
  )
}

function Dismiss({ offer: { offer, text }, contractId }: { offer: ChangeOffer; contractId: string }) {
  const dismiss = useChangeOrder(contractId)
  return (
    <ReasonForm
      label={`Dismiss: ${text}`}
      draftKey={`dismiss-offer:${contractId}:${offer}`}
      field="Why no change order is needed"
      description="For your side only: the other side still sees the change, and reads this reason."
      mutation={dismiss}
      onSend={(reason, onSent) =>
        dismiss.mutate(
          { does: 'dismiss', offer, reason },
          {
            onSuccess: () => {
              onSent()
              showToast('Dismissed. The record keeps the reason.')
            },
          },
        )
      }
      className={classes.inner}
    >
      Dismiss with this reason
    </ReasonForm>
  )
}
