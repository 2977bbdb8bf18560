import { useId } from 'react'

import { type ExtraRound, useSettleRound } from '@/money/api'
import { money } from '@/money/words'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Row, Rows } from '@/ui/Rows'
import { Refusal } from '@/ui/Refusal'

interface RoundsCardProps {
  rounds: readonly ExtraRound[]
  /** The contract's. */
  title: string
  side: 'team' | 'designer'
  isProducer: boolean
}

/** Rounds beyond those included, waiting for a decision on their price. */
export function RoundsCard({ rounds, title, side, isProducer }: RoundsCardProps) {
  const id = useId()
  if (rounds.length === 0) return null
  return (
    <Card aria-label={`Extra revision rounds, ${title}`}>
      <CardHead id={id} title="Extra revision rounds" count={rounds.length} end="priced in the contract" />
      <Rows>
        {rounds.map((round) => (
          <Round key={round.id} round={round} side={side} isProducer={isProducer} />
        ))}
      </Rows>
    </Card>
  )
}

function Round({ round, side, isProducer }: { round: ExtraRound; side: 'team' | 'designer'; isProducer: boolean }) {
  const settle = useSettleRound(round.id)
  const price = money(round.amount_minor, round.currency)
  return (
    <Row>
      <span className="grow">
        <span className="strong">{round.cue.name}</span>
        <span className="small mid">
          {' '}
          round {round.number} of {round.included}, {price}
        </span>
        <Refusal error={settle.error} />
      </span>
      {side === 'team' && isProducer && (
        <Button onClick={() => settle.mutate('agree')} aria-label={`Agree to ${price} for ${round.cue.name}`}>
          Agree to {price}
        </Button>
      )}
      {side === 'designer' && (
        <Button
          variant="quiet"
          onClick={() => settle.mutate('drop')}
          aria-label={`Waive the fee for round ${round.number} of ${round.cue.name}`}
        >
          Waive the fee
        </Button>
      )}
    </Row>
  )
}
