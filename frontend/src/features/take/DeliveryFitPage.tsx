import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { StartPageLink } from '@/app/shell/StartPageLink'
import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { plural } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { Table } from '@/ui/Table'
import { PageWait } from '@/ui/PageWait'

import { deliveryFitQuery } from './api'
import { type DeliveryFit, moved, WHAT } from './fit'
import classes from './Fit.module.css'

/** A delivery compared with other designers' earlier work: whether a new designer matches it. */
export function DeliveryFitPage() {
  const { deliveryId } = useParams({ from: '/shell/deliveries/$deliveryId/fit' })
  const { data: fit, error } = useQuery(deliveryFitQuery(deliveryId))
  useTitle(fit ? `Delivery ${fit.number} compared with earlier work` : 'Delivery')
  if (fit === undefined) {
    return <PageWait isNamed title="Delivery" error={error} action={<StartPageLink />} />
  }
  return (
    <div className="page stack">
      <PageHead title={<>Delivery {fit.number} compared with earlier work</>}>
        From {fit.designer.name}
        {fit.is_first && ', their first delivery here'}
        {fit.made_before_by.length > 0 && `; approved earlier: sounds by ${fit.made_before_by.join(', ')}`}.{' '}
        <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId: fit.project_id }}>
          Sound list
        </Link>
      </PageHead>
      {fit.shifts.length === 0 ? <Nothing fit={fit} /> : <Shifts fit={fit} />}
      {fit.takes.length > 0 && <Takes fit={fit} />}
    </div>
  )
}

function Nothing({ fit }: { fit: DeliveryFit }) {
  return (
    <EmptyState head="Nothing to compare yet">
      {fit.made_before_by.length === 0
        ? 'No sound by another designer is approved in this project.'
        : 'Sounds are compared once they pass the check and three other cues in their category, or in the palette, are approved.'}
    </EmptyState>
  )
}

function Shifts({ fit }: { fit: DeliveryFit }) {
  return (
    <Card aria-labelledby="shifts">
      <CardHead id="shifts" title="Overall" note="its median sound against the approved sounds" />
      <div className="grid gap-3 p-3-inset-14px">
        <Table
          label="The delivery overall"
          rows={fit.shifts}
          keyOf={({ measure }) => measure}
          columns={[
            { head: 'Measure', rowHead: true, cell: ({ measure }) => WHAT[measure].replace(', from the median', '') },
            { head: 'Offset from median', numeric: true, cell: ({ measure, shift }) => moved(measure, shift) },
            { head: 'Outliers', numeric: true, cell: ({ apart, compared }) => `${apart} of ${compared}` },
          ]}
        />
      </div>
    </Card>
  )
}

function Takes({ fit }: { fit: DeliveryFit }) {
  const apart = fit.takes.filter(({ is_apart }) => is_apart).length
  return (
    <Card aria-labelledby="takes">
      <CardHead
        id="takes"
        title="Sound by sound"
        end={`${apart} of ${plural(fit.takes.length, 'sound')} ${apart === 1 ? 'is an outlier' : 'are outliers'}`}
      />
      <ul className={classes.takes}>
        {fit.takes.map((take) => (
          <li key={take.take_id}>
            <Link className="link strong" to="/takes/$takeId" params={{ takeId: take.take_id }}>
              {take.cue?.name ?? 'A version'}
            </Link>{' '}
            <span className="mono small mid">{take.file_name}</span>
            <p className={`small ${take.is_apart ? '' : 'mid'}`}>{take.says}</p>
          </li>
        ))}
      </ul>
    </Card>
  )
}
