import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { ShellLink } from '@/app/shell/ShellLink'
import { useTitle } from '@/app/title'
import { ended } from '@/judging/findings'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { plural } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'

import { deliveryFitQuery } from './api'
import { type DeliveryFit, moved, WHAT } from './fit'
import classes from './Fit.module.css'

/** A delivery beside what other designers made before: whether somebody who takes over goes on where they stood. */
export function DeliveryFitPage() {
  const { deliveryId } = useParams({ from: '/shell/deliveries/$deliveryId/fit' })
  const { data: fit, error } = useQuery(deliveryFitQuery(deliveryId))
  useTitle(fit ? `Delivery ${fit.number} beside the work before` : 'Delivery')
  if (fit === undefined) {
    const problem = error instanceof ApiProblem ? error : null
    return (
      <div className="page stack">
        <h1 className={problem ? undefined : 'visually-hidden'}>
          {problem ? 'This delivery is not here.' : 'Delivery'}
        </h1>
        {problem && (
          <ProblemNote
            detail={ended(problem.detail)}
            fix={ended(problem.fix)}
            action={
              <ShellLink path="/" className="link">
                To the start
              </ShellLink>
            }
          />
        )}
      </div>
    )
  }
  return (
    <div className="page stack">
      <header>
        <h1>Delivery {fit.number} beside the work before</h1>
        <p className="mid">
          From {fit.designer.name}
          {fit.is_first && ', the first of them here'}
          {fit.made_before_by.length > 0 && `; approved before: sounds of ${fit.made_before_by.join(', ')}`}.{' '}
          <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId: fit.project_id }}>
            Sound list
          </Link>
        </p>
      </header>
      {fit.shifts.length === 0 ? <Nothing fit={fit} /> : <Shifts fit={fit} />}
      {fit.takes.length > 0 && <Takes fit={fit} />}
    </div>
  )
}

function Nothing({ fit }: { fit: DeliveryFit }) {
  return (
    <EmptyState head="Nothing can be compared yet.">
      {fit.made_before_by.length === 0
        ? 'No sound of another designer is approved in this project.'
        : 'Sounds are compared once they conform and three other cues of their category, or of the palette, are approved.'}
    </EmptyState>
  )
}

function Shifts({ fit }: { fit: DeliveryFit }) {
  return (
    <Card aria-labelledby="shifts">
      <CardHead id="shifts" title="As a whole" note="its middle sound against what each is compared with" />
      <div className={classes.inside}>
        <table className={classes.table} aria-label="How the delivery lies as a whole">
          <thead>
            <tr>
              <th scope="col">Measure</th>
              <th scope="col">Off the middle by</th>
              <th scope="col">Stand apart</th>
            </tr>
          </thead>
          <tbody>
            {fit.shifts.map(({ measure, shift, apart, compared }) => (
              <tr key={measure}>
                <th scope="row">{WHAT[measure].replace(', from the middle', '')}</th>
                <td>{moved(measure, shift)}</td>
                <td>
                  {apart} of {compared}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      </div>
    </Card>
  )
}

function Takes({ fit }: { fit: DeliveryFit }) {
  const apart = fit.takes.filter(({ is_apart }) => is_apart).length
  return (
    <Card aria-labelledby="takes">
      <CardHead id="takes" title="Sound by sound" end={`${plural(apart, 'sound')} of ${fit.takes.length} apart`} />
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
