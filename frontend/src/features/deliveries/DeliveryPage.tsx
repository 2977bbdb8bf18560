import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { projectQuery } from '@/api/project'
import { useRoles } from '@/api/roles'
import { useTitle } from '@/app/title'
import { reasonsText } from '@/verdicts/words'
import { ClosedGateNote } from '@/phases'
import { Card, CardHead } from '@/ui/Card'
import { PageWait } from '@/ui/PageWait'
import { bytes, plural } from '@/ui/format'
import { Person } from '@/ui/Person'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Archive, type DeliveryDetail, deliveryQuery, type Take } from './api'
import classes from './Deliveries.module.css'
import { countsOf, daysOf, filesOf, standOf, versionOf } from './words'

/** One delivery, open or closed: who sent it and when, and what happened to every file. */
export function DeliveryPage() {
  const { deliveryId } = useParams({ from: '/shell/deliveries/$deliveryId' })
  const { data: delivery, error } = useQuery(deliveryQuery(deliveryId))
  useTitle(delivery ? `Delivery ${delivery.number}` : 'Delivery')
  if (delivery === undefined) {
    return <PageWait isNamed title="Delivery" error={error} />
  }
  return (
    <div className="page stack">
      <Head delivery={delivery} />
      <ClosedGateNote
        projectId={delivery.project_id}
        cueIds={delivery.takes.flatMap(({ cue }) => (cue ? [cue.id] : []))}
      />
      <Files takes={delivery.takes} />
      {delivery.dry_stems.length > 0 && <DryStems stems={delivery.dry_stems} />}
      {delivery.archives.map((archive) => (
        <ArchiveCard key={archive.id} archive={archive} />
      ))}
    </div>
  )
}

function Head({ delivery }: { delivery: DeliveryDetail }) {
  const { data: project } = useQuery(projectQuery(delivery.project_id))
  const roleOf = useRoles(delivery.project_id)
  const isTeam = project?.mine.is_team ?? false
  const params = { projectId: delivery.project_id }
  const counts = countsOf(delivery)
  return (
    <header className="grid gap-2">
      <h1>Delivery {delivery.number}</h1>
      <p className="flex wrap items-center gap-2-4">
        <Person name={delivery.designer.name} picture={delivery.designer.picture} role={roleOf(delivery.designer.id)} />
        <span className="mid">{daysOf(delivery)}</span>
      </p>
      {delivery.note && <p>“{delivery.note}”</p>}
      {counts.length > 0 && (
        <ul className={`flex wrap items-center gap-2-4 ${classes.counts}`} aria-label="How its files stand">
          {counts.map(({ kind, files }) => (
            <li key={kind}>
              <StatusBadge kind={kind} /> <span className="num small mid">{files}</span>
            </li>
          ))}
        </ul>
      )}
      <p className="flex wrap items-center gap-2-4">
        <Link className="link" to="/projects/$projectId/deliveries" params={params}>
          All deliveries
        </Link>
        <Link className="link" to="/deliveries/$deliveryId/fit" params={{ deliveryId: delivery.id }}>
          Compare with earlier work
        </Link>
        {isTeam && counts.some(({ kind }) => kind === 'to_review') && (
          <Link className="link" to="/projects/$projectId/review" params={params}>
            Review
          </Link>
        )}
        {project && !isTeam && (
          <Link className="link" to="/projects/$projectId/desk" params={params}>
            Desk
          </Link>
        )}
      </p>
    </header>
  )
}

function Files({ takes }: { takes: readonly Take[] }) {
  return (
    <Card aria-labelledby="files">
      <CardHead id="files" title="Files" note={filesOf(takes.length)} />
      {takes.length === 0 && <p className="mid p-3-inset">No file has arrived.</p>}
      <ul className={classes.files} aria-label="Files">
        {takes.map((take) => (
          <li key={take.id}>
            <Link className="link mono wrap-anywhere" to="/takes/$takeId" params={{ takeId: take.id }}>
              {take.file_name}
            </Link>
            <span className="cut-text">
              {take.cue && <span className="mono dim small">{take.cue.label} </span>}
              {take.cue?.name}
            </span>
            <span className="small mid">
              {[versionOf(take), bytes(take.master_bytes), take.late ? 'after it was closed' : '']
                .filter(Boolean)
                .join(', ')}
            </span>
            {take.discarded_at === null ? (
              <StatusBadge kind={standOf(take)} />
            ) : (
              <span className="small dim">Discarded; the file is kept</span>
            )}
            {take.verdict_reasons.length > 0 && (
              <span className="small mid col-span-full">{reasonsText(take.verdict_reasons)}</span>
            )}
            {take.note && <span className="small mid col-span-full">“{take.note}”</span>}
          </li>
        ))}
      </ul>
    </Card>
  )
}

function DryStems({ stems }: { stems: DeliveryDetail['dry_stems'] }) {
  return (
    <Card aria-labelledby="stems">
      <CardHead id="stems" title="Dry stems" note={filesOf(stems.length)} />
      <ul className={classes.files} aria-label="Dry stems">
        {stems.map((stem) => (
          <li key={stem.id}>
            <span className="mono wrap-anywhere">{stem.file_name}</span>
            <span className="small mid">
              {stem.take_ids.length > 0 ? `for ${plural(stem.take_ids.length, 'file')}` : 'its version is missing'}
            </span>
          </li>
        ))}
      </ul>
    </Card>
  )
}

function ArchiveCard({ archive }: { archive: Archive }) {
  const left = archive.entries.filter(({ taken, reason }) => !taken || reason !== null)
  const taken = archive.entries.filter((entry) => entry.taken).length
  const id = `archive-${archive.id}`
  return (
    <Card aria-labelledby={id}>
      <CardHead
        id={id}
        title={archive.file_name}
        note={archive.state === 'received' ? 'unpacking' : `${filesOf(taken)} unpacked`}
        end={archive.state === 'refused' ? <StatusBadge kind="refused" /> : undefined}
      />
      {archive.message && <p className="mid p-3-inset">{archive.message}</p>}
      {left.length > 0 && (
        <ul className={classes.files} aria-label={`Entries of ${archive.file_name} that were left out`}>
          {left.map((entry) => (
            <li key={entry.path}>
              <span className="mono wrap-anywhere">{entry.path}</span>
              <span className="small mid">{entry.reason ?? 'Skipped.'}</span>
            </li>
          ))}
        </ul>
      )}
    </Card>
  )
}
