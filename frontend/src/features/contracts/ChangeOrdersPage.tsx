import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { ReasonForm } from '@/app/ReasonForm'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { clock, day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { PageWait } from '@/ui/PageWait'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'
import { sentence } from '@/ui/sentence'

import { type ChangeOffer, type ChangeOrder, type ChangeOrders, changeOrdersQuery, useChangeOrder } from './api'
import classes from './Contracts.module.css'
import { DifferenceView } from './DifferenceView'
import { DrawnName } from './DrawnName'
import { OffersCard } from './OffersCard'
import { ProposeChange } from './ProposeChange'
import { SignForm } from './SignForm'
import { Text } from './Text'
import { Warning } from './Warning'

/** The change orders of a contract: what each changes, who has signed it, and a new one. */
export function ChangeOrdersPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/changes' })
  const { data: all, error } = useQuery(changeOrdersQuery(contractId))
  const [picked, setPicked] = useState<ChangeOffer | null>(null)
  useTitle('Change orders')
  if (!all) {
    return <PageWait title="Change orders" error={error} />
  }
  return (
    <div className="page stack">
      <PageHead
        title="Change orders"
        actions={
          <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contractId}`}>
            {all.title}
          </ButtonLink>
        }
      >{`to ${all.title}. What is signed stays; a change order says only what is different.`}</PageHead>
      <div className={`columns ${classes.columns}`}>
        <div className="stack">
          <OffersCard all={all} onPropose={setPicked} />
          {all.orders.length === 0 && (
            <EmptyState head="No change order yet">
              {all.may_propose
                ? 'Propose one: a cue, a cut, a price, a round, a date, or work beside the cues.'
                : 'Only the two parties of a running contract propose one.'}
            </EmptyState>
          )}
          {all.orders.toReversed().map((order) => (
            <Order key={order.number} order={order} all={all} />
          ))}
        </div>
        <div className="stack">
          {all.may_propose && <ProposeChange all={all} picked={picked} onBegun={() => setPicked(null)} />}
        </div>
      </div>
    </div>
  )
}

const STATES: Record<ChangeOrder['state'], { kind: StateKind; word: string }> = {
  proposed: { kind: 'waiting', word: 'Proposed' },
  agreed: { kind: 'accepted', word: 'In force' },
  refused: { kind: 'returned', word: 'Refused' },
  withdrawn: { kind: 'cut', word: 'Withdrawn' },
  lapsed: { kind: 'cut', word: 'Lapsed' },
}

function Order({ order, all }: { order: ChangeOrder; all: ChangeOrders }) {
  const { kind, word } = STATES[order.state]
  const head = `order-${order.number}`
  return (
    <Card aria-labelledby={head}>
      <CardHead
        id={head}
        title={`Change order ${order.number}`}
        note={`${order.proposed_by}, for the ${order.party}, ${day(order.proposed_at)}`}
        end={
          <StatusBadge kind={order.may.agree ? 'to_review' : kind}>
            {order.may.agree ? 'Needs your signature' : word}
          </StatusBadge>
        }
      />
      <div className={classes.form}>
        <p>{order.reason}</p>
        {order.problems.map((problem) => (
          <Warning key={problem}>{sentence(problem)}</Warning>
        ))}
        {order.difference !== null && <DifferenceView difference={order.difference} currency={all.currency} />}
        {order.begins_at_once && (
          <Warning>{`Work may begin before both have signed, at the risk of the ${order.party}.`}</Warning>
        )}
        {order.close_reason !== '' && order.closed_at !== null && (
          <p className="mid">{`${word} on ${day(order.closed_at)}: ${order.close_reason}`}</p>
        )}
      </div>
      <Rows aria-label="Signed by">
        {order.signed.map(({ party, name, drawing, accepted_at: at }) => (
          <Row key={at} className={classes.row}>
            <div className="grow">
              <p>{`Signed by ${name}, for the ${party}`}</p>
              {drawing !== null && <DrawnName strokes={drawing} name={name} />}
            </div>
            <span className="small dim">{`${day(at)}, ${clock(at)}`}</span>
          </Row>
        ))}
      </Rows>
      <div className={classes.form}>
        {order.may.agree && <Sign order={order} contractId={all.contract_id} />}
        {order.may.refuse && <Close order={order} contractId={all.contract_id} does="refuse" />}
        {order.may.withdraw && <Close order={order} contractId={all.contract_id} does="withdraw" />}
        <details className={classes.end}>
          <summary>Full text</summary>
          <Text blocks={order.blocks} />
          <p className={`mono dim ${classes.hash}`}>{`SHA-256 ${order.text_sha256}`}</p>
        </details>
        <ButtonLink
          variant="quiet"
          icon="download"
          href={`/v1/contracts/${all.contract_id}/change-orders/${order.number}/change-order.pdf`}
          aria-label={`Change order ${order.number} as PDF`}
        >
          PDF
        </ButtonLink>
      </div>
    </Card>
  )
}

function Sign({ order, contractId }: { order: ChangeOrder; contractId: string }) {
  const sign = useChangeOrder(contractId)
  const isLast = order.signed.length === order.signatures_needed - 1
  const textSha256 = order.text_sha256
  return (
    <SignForm
      contractId={contractId}
      textSha256={textSha256}
      label={`Sign change order ${order.number}`}
      button={`Sign change order ${order.number}`}
      onSign={async (signed) => {
        await sign.mutateAsync({ does: 'accept', number: order.number, textSha256, ...signed })
        showToast(isLast ? `Change order ${order.number} is in force.` : 'Signed.')
      }}
    />
  )
}

function Close({ order, contractId, does }: { order: ChangeOrder; contractId: string; does: 'refuse' | 'withdraw' }) {
  const close = useChangeOrder(contractId)
  const word = does === 'refuse' ? 'Refuse' : 'Withdraw'
  return (
    <ReasonForm
      label={`${word} change order ${order.number}`}
      draftKey={`change-order-${does}:${contractId}:${order.number}`}
      field={`${word}, reason`}
      mutation={close}
      onSend={(reason, onSuccess) => close.mutate({ does, number: order.number, reason }, { onSuccess })}
      className={classes.inner}
    >
      {word}
    </ReasonForm>
  )
}
