import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { type Bonus, type ContractMoney, ledgerQuery, useSayShipped } from '@/money/api'
import { money } from '@/money/words'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { today } from '@/ui/format'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'

import classes from './Page.module.css'

const WHEN: Record<Bonus['when'], string> = {
  on_time: 'Due when every cue is accepted by the date of its milestone.',
  no_rejected_take: 'Due when every cue is accepted without a round of changes.',
  shipped: 'Due when the studio says that the game has shipped.',
  other: 'You agree on it yourselves, by a change order, when this has happened:',
}

const STATES: Record<NonNullable<Bonus['state']>, { kind: StateKind; word: string }> = {
  earned: { kind: 'accepted', word: 'Earned' },
  possible: { kind: 'waiting', word: 'Still possible' },
  missed: { kind: 'cut', word: 'Missed' },
}

interface BonusCardProps {
  contract: ContractMoney
  isProducer: boolean
}

/** The bonus of a contract: what sets it off, and whether it is earned, still possible or missed, and why. */
export function BonusCard({ contract, isProducer }: BonusCardProps) {
  const { contract_id: contractId, currency, title } = contract
  const { data: ledger } = useQuery(ledgerQuery(contractId))
  const bonus = ledger?.bonus
  if (!bonus) return null
  const state = bonus.state && STATES[bonus.state]
  return (
    <Card aria-label={`Bonus, ${title}`}>
      <CardHead
        id={`bonus-${contractId}`}
        title="Bonus"
        note={money(bonus.amount_minor, currency)}
        end={state && <StatusBadge kind={state.kind}>{state.word}</StatusBadge>}
      />
      <div className="p-3-inset">
        <p className="small mid">{WHEN[bonus.when]}</p>
        <p>{sentence(bonus.because)}</p>
      </div>
      {isProducer && bonus.when === 'shipped' && bonus.state === 'possible' && (
        <SayShipped contractId={contractId} title={title} amount={money(bonus.amount_minor, currency)} />
      )}
    </Card>
  )
}

const sentence = (text: string): string => `${text.charAt(0).toUpperCase()}${text.slice(1).replace(/\.$/, '')}.`

function SayShipped({ contractId, title, amount }: { contractId: string; title: string; amount: string }) {
  const say = useSayShipped(contractId)
  return (
    <Form
      className={`grid gap-3 ${classes.form}`}
      aria-label={`Record release date, ${title}`}
      initialValues={{ on: today() }}
      mutation={say}
      onSubmit={({ on }) => say.mutate(on, { onSuccess: () => showToast(`The bonus of ${amount} is due.`) })}
    >
      <Field
        name="on"
        label="Shipped on"
        description={`Makes ${amount} due. This cannot be undone.`}
        type="date"
        max={today()}
      />
      <Submit variant="plain" className="row wrap justify-end col-span-full">
        Record release date
      </Submit>
    </Form>
  )
}
