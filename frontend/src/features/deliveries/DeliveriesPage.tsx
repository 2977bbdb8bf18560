import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { projectQuery } from '@/api/project'
import { useTitle } from '@/app/title'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { PageHead } from '@/ui/PageHead'
import { Person } from '@/ui/Person'
import { Refusal } from '@/ui/Refusal'
import { Row, Rows } from '@/ui/Rows'
import { ShowMore } from '@/ui/ShowMore'

import { type Delivery, useDeliveries } from './api'
import classes from './Deliveries.module.css'
import { daysOf, filesOf } from './words'

/** Every delivery of a project, open and closed, the newest first. */
export function DeliveriesPage() {
  useTitle('Deliveries')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/deliveries' })
  const { data: project } = useQuery(projectQuery(projectId))
  const list = useDeliveries(projectId)
  const { data, error } = list
  const deliveries = data?.pages.flatMap(({ items }) => items)
  const isTeam = project?.mine.is_team ?? false
  return (
    <div className="page stack">
      <PageHead title="Deliveries">
        <Link className="link" to="/projects/$projectId" params={{ projectId }}>
          {project?.name ?? 'Project'}
        </Link>
        {project?.mine.is_team === false && (
          <>
            {' · '}
            <Link className="link" to="/work">
              Your credits, people and playlists
            </Link>
          </>
        )}
      </PageHead>
      <Refusal error={error} />
      {deliveries?.length === 0 && (
        <EmptyState head="No deliveries yet">
          {isTeam ? 'A delivery begins with the first file that a designer uploads.' : 'Your first upload begins one.'}
        </EmptyState>
      )}
      {deliveries !== undefined && deliveries.length > 0 && (
        <Card aria-label="Deliveries">
          <Rows aria-label="Deliveries">
            {deliveries.map((delivery) => (
              <Line key={delivery.id} delivery={delivery} showsDesigner={isTeam} />
            ))}
          </Rows>
          {list.hasNextPage && (
            <div className="p-10px-inset">
              <ShowMore list={list}>Earlier deliveries</ShowMore>
            </div>
          )}
        </Card>
      )}
    </div>
  )
}

function Line({ delivery, showsDesigner }: { delivery: Delivery; showsDesigner: boolean }) {
  return (
    <Row className={classes.line}>
      <Link className="link strong nowrap" to="/deliveries/$deliveryId" params={{ deliveryId: delivery.id }}>
        Delivery {delivery.number}
      </Link>
      <span className="wrap-anywhere">{delivery.note}</span>
      {showsDesigner ? (
        <Person name={delivery.designer.name} picture={delivery.designer.picture} />
      ) : (
        <span className="wide-only" />
      )}
      <span className="small mid num nowrap">{filesOf(delivery.takes_count)}</span>
      <span className="small dim nowrap">{daysOf(delivery)}</span>
    </Row>
  )
}
