import { ended } from '@/verdicts/findings'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { bytes } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { StatusBadge } from '@/ui/StatusBadge'

import { type MasterExport, type Take, useMasterExport } from './api'
import classes from './Take.module.css'

/** By the names of ASWG-G006, in the order in which they are read. */
const METADATA_LABELS = {
  project: 'Project',
  originatorStudio: 'Studio',
  originator: 'Made by',
  orderRef: 'Cue',
  fxName: 'Name',
  notes: 'Note',
} as const

interface MasterCardProps {
  take: Take
  /** Why it cannot be downloaded now, where its contract opens files by payment. */
  closed: string | null
}

/** The master to take along: as it was delivered, or as a copy that says where it comes from. */
export function MasterCard({ take, closed }: MasterCardProps) {
  return (
    <Card aria-labelledby="master">
      <CardHead id="master" title="Master" end={bytes(take.master_bytes)} />
      <div className="stack p-3-inset-14px">
        {closed === null ? (
          <Downloads take={take} />
        ) : (
          <>
            <p>
              <StatusBadge kind="waiting">Available after payment</StatusBadge>
            </p>
            <p className="small mid">{ended(closed)} You can listen to the preview until then.</p>
          </>
        )}
      </div>
    </Card>
  )
}

function Downloads({ take }: { take: Take }) {
  const { ask, made, making, error } = useMasterExport(take.id)
  return (
    <>
      <p className="small mid">
        The file exactly as delivered, or a copy of it with provenance metadata (bext and iXML).
      </p>
      <div className="row wrap">
        <ButtonLink href={`/v1/takes/${take.id}/master`} download icon="download">
          Download as delivered
        </ButtonLink>
        {made?.file_url ? (
          <ButtonLink href={made.file_url} download={made.file_name} icon="download">
            Download with provenance
          </ButtonLink>
        ) : (
          <Button icon="file" disabled={making} onClick={() => ask.mutate()}>
            Create copy with provenance
          </Button>
        )}
      </div>
      <p className="small dim" role="status">
        {making && 'Creating the copy…'}
        {made?.file_bytes && `The copy (${bytes(made.file_bytes)}) contains:`}
      </p>
      {made?.file_url && <Fields made={made} />}
      {made?.refusal && <ErrorBanner detail={ended(made.refusal)} />}
      <Refusal error={error} />
    </>
  )
}

function Fields({ made: { fields, left } }: { made: MasterExport }) {
  return (
    <>
      <dl className={classes.lines}>
        {Object.entries(METADATA_LABELS).map(
          ([field, label]) =>
            fields[field] && (
              <div key={field}>
                <dt className="dim">{label}</dt>
                <dd>{fields[field]}</dd>
              </div>
            ),
        )}
      </dl>
      {left.map((sentence) => (
        <p key={sentence} className="small mid">
          {ended(sentence)}
        </p>
      ))}
    </>
  )
}
