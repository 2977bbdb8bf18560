import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { useTitle } from '@/app/title'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Refusal } from '@/ui/Refusal'
import { clock, day } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { PageHead } from '@/ui/PageHead'
import { sentence } from '@/ui/sentence'

import { type Entry, recordQuery } from './api'
import classes from './Contracts.module.css'
import { authorOf, eventOf, factsOf } from './words'

/** The record of a contract: every entry, chained to the one before. */
export function RecordPage() {
  const { projectId, contractId } = useParams({ from: '/shell/projects/$projectId/contracts/$contractId/record' })
  const { data: record, error } = useQuery(recordQuery(contractId))
  useTitle('Audit trail')
  return (
    <div className="page stack" aria-busy={!record && error === null}>
      <PageHead
        title="Audit trail"
        actions={
          <>
            <ButtonLink component={Link} to={`/projects/${projectId}/contracts/${contractId}`}>
              Back to contract
            </ButtonLink>
            <ButtonLink icon="download" href={`/v1/contracts/${contractId}/head.json`}>
              Signed head
            </ButtonLink>
            <ButtonLink variant="primary" icon="download" href={`/v1/contracts/${contractId}/record.json`}>
              Download a copy
            </ButtonLink>
          </>
        }
      >
        {record ? `${record.title}. ` : ''}
        Each entry contains the hash of the one before it, so any later change can be detected.
      </PageHead>
      <Refusal error={error} />
      {record && record.faults.length > 0 && (
        <ErrorBanner
          detail={`This audit trail was altered: ${record.faults.map(sentence).join(' ')}`}
          fix="Compare it with your own copy and contact the server’s administrator."
        />
      )}
      {record && (
        <Card aria-labelledby="entries">
          <CardHead
            id="entries"
            title="Entries"
            count={record.length}
            note={record.faults.length === 0 && record.length > 0 ? 'verified just now' : undefined}
          />
          {record.length === 0 && (
            <div className="p-inset">
              <EmptyState head="No entries yet." level={3}>
                The audit trail starts when the contract is first sent.
              </EmptyState>
            </div>
          )}
          <ol className={` ${classes.entries}`}>
            {record.entries.map((entry) => (
              <Line key={entry.seq} entry={entry} />
            ))}
          </ol>
        </Card>
      )}
    </div>
  )
}

function Line({ entry }: { entry: Entry }) {
  return (
    <li>
      <p>
        <span className="mono dim">{entry.seq}</span> <strong>{eventOf(entry)}</strong>
        <span className="small mid">
          {authorOf(entry)}
          {`, ${day(entry.at)}, ${clock(entry.at)}`}
        </span>
      </p>
      <dl className={`flex wrap gap-2px-4 ${classes.facts}`}>
        {factsOf(entry).map(({ name, value }) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <p className={`mono dim ${classes.hash}`}>{entry.sha256}</p>
    </li>
  )
}
