import { useInfiniteQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { bytes, countOf, plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import { Row, Rows } from '@/ui/Rows'
import { ShowMore } from '@/ui/ShowMore'
import { StatusBadge } from '@/ui/StatusBadge'

import { limitsQuery, type Limits, type Quota, type Scope, share } from './api'

const NEAR = 0.9
const SHOWN = 3 // limits of a studio: the nearest

const NAMES: Record<Quota['kind'], string> = {
  master_bytes: 'Storage for masters',
  cues: 'Cues',
  projects: 'Projects',
  people: 'Members',
  tokens: 'Tokens',
  open_uploads: 'Unfinished uploads',
  reference_bytes: 'Storage for references',
  reel_bytes: 'Storage for reels on the roster',
}
const isNear = ({ quotas: [first] }: Limits) => first !== undefined && share(first) >= NEAR

/** What studios use of their limits: who is nearest to one comes first. */
export function LimitsCard({ scope }: { scope: Scope }) {
  const list = useInfiniteQuery(limitsQuery(scope))
  const { data, error } = list
  const studios = data?.pages.flatMap(({ items }) => items)
  const near = studios?.filter(isNear).length ?? 0
  return (
    <Card aria-labelledby="limits">
      <CardHead
        id="limits"
        title="Limits"
        note={studios && (near === 0 ? 'none is near' : scope === 'server' ? `${plural(near, 'studio')} near` : 'near')}
      />
      {error && (
        <div className="p-inset">
          <Refusal error={error} />
        </div>
      )}
      <Rows aria-labelledby="limits">
        {studios?.map(({ studioId, studioName, quotas }) => (
          <Row key={studioId}>
            <div className="grow">
              {studioName !== '' && <p className="strong">{studioName}</p>}
              {quotas.slice(0, SHOWN).map((quota) => (
                <Limit key={quota.kind} quota={quota} />
              ))}
            </div>
          </Row>
        ))}
      </Rows>
      {list.hasNextPage && (
        <div className="p-inset">
          <ShowMore list={list}>Show more studios</ShowMore>
        </div>
      )}
      {scope === 'server' && (
        <p className="small mid p-inset">
          Set one with <code>soundlist quota STUDIO_ID --set cues=20000</code>
        </p>
      )}
    </Card>
  )
}

function Limit({ quota }: { quota: Quota }) {
  const { kind, used, limit } = quota
  const inWords = kind.endsWith('_bytes') ? `${bytes(used)} of ${bytes(limit)}` : countOf(used, limit)
  const tone = used >= limit ? 'bad' : share(quota) >= NEAR ? 'warn' : undefined
  return (
    <div>
      <p className="small flex between gap-3">
        <span>{NAMES[kind]}</span>
        <span className="num">{inWords}</span>
      </p>
      <Meter thin label={`${NAMES[kind]}: ${inWords}`} whole={limit} parts={[{ value: used, tone }]} />
      {tone === 'bad' && <StatusBadge kind="refused">Limit reached</StatusBadge>}
      {tone === 'warn' && <StatusBadge kind="warning">Almost full</StatusBadge>}
    </div>
  )
}
