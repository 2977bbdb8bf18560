import { Card, CardHead } from '@/ui/Card'
import { bytes, countOf } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge, type Tone } from '@/ui/StatusBadge'

import { type Quota, useQuotas } from './api'
import { CardProblem } from './CardProblem'

const NEAR = 0.9

const WORDS: Record<Quota['kind'], { name: string; atLimit: string }> = {
  master_bytes: {
    name: 'Storage for masters',
    atLimit: 'New uploads are refused. Finished uploads are never refused.',
  },
  cues: { name: 'Cues', atLimit: 'No cue can be added or imported.' },
  projects: { name: 'Projects', atLimit: 'No project can be created.' },
  people: { name: 'Members', atLimit: 'No one else can join the studio. Designers don’t count.' },
  tokens: { name: 'Tokens', atLimit: 'Revoke a token to create another.' },
  open_uploads: {
    name: 'Unfinished uploads',
    atLimit: 'New uploads are refused until others finish or expire.',
  },
  reference_bytes: { name: 'Storage for references', atLimit: 'New references are refused. Links can still be added.' },
  reel_bytes: { name: 'Storage for reels', atLimit: 'New sounds on the roster are refused. Links can still be added.' },
}

/** What the studio uses of the limits of this server, and what happens at each. */
export function QuotasCard({ studioId }: { studioId: string }) {
  const { data: quotas, error } = useQuotas(studioId)
  return (
    <Card aria-labelledby="quotas">
      <CardHead id="quotas" title="Limits" note="for the whole studio" />
      <CardProblem error={error} />
      <Rows aria-labelledby="quotas">
        {quotas?.map((quota) => (
          <QuotaRow key={quota.kind} quota={quota} />
        ))}
      </Rows>
      <p className="small mid p-3-inset">
        Nothing is deleted when a limit is reached. The server’s administrator can raise it with{' '}
        <code>soundlist quota</code>.
      </p>
    </Card>
  )
}

function QuotaRow({ quota: { kind, used, limit } }: { quota: Quota }) {
  const { name, atLimit } = WORDS[kind]
  const inWords = kind.endsWith('_bytes') ? `${bytes(used)} of ${bytes(limit)}` : countOf(used, limit)
  const isFull = used >= limit
  const isNear = !isFull && used >= limit * NEAR
  const tone: Tone | undefined = isFull ? 'bad' : isNear ? 'warn' : undefined
  return (
    <Row>
      <div className="grow">
        <p className="flex between gap-2">
          <span className="strong">{name}</span>
          <span className="num small">{inWords}</span>
        </p>
        <Meter thin label={`${name}: ${inWords}`} whole={limit} parts={[{ value: used, tone }]} />
        <p className="small dim">
          {isFull ? (
            <StatusBadge kind="refused">Limit reached</StatusBadge>
          ) : (
            isNear && <StatusBadge kind="warning">Almost full</StatusBadge>
          )}{' '}
          {isFull || isNear ? atLimit : `At the limit: ${atLimit.charAt(0).toLowerCase()}${atLimit.slice(1)}`}
        </p>
      </div>
    </Row>
  )
}
