import { useInfiniteQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import { useState } from 'react'

import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { clock, day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Row, Rows } from '@/ui/Rows'
import { Select } from '@/ui/Select'

import { CardProblem } from './CardProblem'
import { type SecurityEvent, type SecurityEventKind, securityEventsQuery } from './securityLogApi'

const KIND_NAMES: Record<SecurityEventKind, string> = {
  sign_in: 'Sign-ins',
  email: 'Emails',
  password: 'Passwords',
  second_factor: 'Second factors',
  roles: 'Roles',
  removal: 'Removals',
  token: 'Tokens',
  webhook: 'Webhooks',
  guest_link: 'Guest links',
  export: 'Exports',
}

/** Who did what in a studio, when and from which network, for its producers. */
export function SecurityLogPage() {
  useTitle('Security log')
  const { studioId } = useParams({ from: '/shell/studio/$studioId/security-log' })
  const [kind, setKind] = useState<SecurityEventKind | ''>('')
  const { data, error, hasNextPage, fetchNextPage, isFetchingNextPage } = useInfiniteQuery(
    securityEventsQuery(studioId, kind),
  )
  return (
    <div className="page">
      <PageHead
        title="Security log"
        actions={
          <ButtonLink
            icon="download"
            href={`/v1/studios/${studioId}/security-events.csv${kind && `?kind=${kind}`}`}
            download
          >
            CSV
          </ButtonLink>
        }
      >
        What members did to accounts and access. Entries are kept for two years.
      </PageHead>
      <Card aria-labelledby="security-log">
        <CardHead id="security-log" title="Events" note="newest first" />
        <div className="p-3-inset">
          <Select label="Show" value={kind} onChange={(event) => setKind(event.target.value as SecurityEventKind | '')}>
            <option value="">All kinds</option>
            {Object.entries(KIND_NAMES).map(([value, name]) => (
              <option key={value} value={value}>
                {name}
              </option>
            ))}
          </Select>
        </div>
        <CardProblem error={error} />
        {data?.length === 0 && <p className="mid p-inset">No events yet.</p>}
        <Rows aria-labelledby="security-log">
          {data?.map((event) => (
            <EventRow key={event.id} event={event} />
          ))}
        </Rows>
        {hasNextPage && (
          <div className="p-3-inset">
            <Button disabled={isFetchingNextPage} onClick={() => void fetchNextPage()}>
              Show earlier events
            </Button>
          </div>
        )}
      </Card>
    </div>
  )
}

function EventRow({ event: { at, person, about, summary, network } }: { event: SecurityEvent }) {
  return (
    <Row>
      <div className="grow">
        <p>
          <span className="strong">{person?.name ?? 'The server’s administrator'}</span>
          {about && <span className="mid"> · {about.name}</span>}
        </p>
        <p className="wrap-anywhere">{summary}</p>
        <p className="small dim">
          <time dateTime={at}>{`${day(at)}, ${clock(at)}`}</time>
          {network && ` · ${network}`}
        </p>
      </div>
    </Row>
  )
}
