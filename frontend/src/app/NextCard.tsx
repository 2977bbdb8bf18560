import type { LinkProps } from '@tanstack/react-router'
import { Link } from '@tanstack/react-router'

import { useRoles } from '@/api/roles'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { age } from '@/ui/format'
import { UnreadDot } from '@/ui/UnreadDot'
import { Person } from '@/ui/Person'
import { Row, Rows } from '@/ui/Rows'

import classes from './NextCard.module.css'
import { type Awaited, awaitedWords, type NextStep, wordsOf } from './nextSteps'

/** What the current person is to do next, by name; the first thing is drawn first. */
export function NextCard({ steps, projectId }: { steps: readonly NextStep[]; projectId: string }) {
  const [first, ...others] = steps
  if (first === undefined) return null
  const { head, why, act, path } = wordsOf(first, projectId)
  return (
    <Card aria-labelledby="next-step">
      <div className={`flex wrap items-center ${classes.first}`}>
        <div className="grow">
          <p className="row small mid">
            <UnreadDot />
            Your next step{first.since ? `, waiting ${age(first.since)}` : ''}
          </p>
          <h2 id="next-step" className={`wrap-anywhere ${classes.head}`}>
            {head}
          </h2>
          <p className="mid">{why}</p>
        </div>
        <ButtonLink component={Link} to={path} variant="primary" data-stop aria-label={`${act}: ${head}`}>
          {act}
        </ButtonLink>
      </div>
      {others.length > 0 && (
        <Rows aria-label="Further steps" className="border-t">
          {others.map((step) => {
            const words = wordsOf(step, projectId)
            return (
              <Row key={`${step.kind} ${step.contract_id} ${step.posting_id} ${step.subject} ${step.who}`}>
                <Link
                  to={words.path as LinkProps['to']}
                  data-stop
                  className={`grow flex wrap items-baseline gap-0-3 min-h-24px ${classes.other}`}
                >
                  <span className="strong">{words.head}</span> <span className="small mid">{words.why}</span>
                </Link>
                {step.since && <span className="dim num small nowrap">{age(step.since)}</span>}
              </Row>
            )
          })}
        </Rows>
      )}
    </Card>
  )
}

/** Who else is to do something, and since when. */
export function AwaitedRows({ awaited, projectId }: { awaited: readonly Awaited[]; projectId: string }) {
  const roleOf = useRoles(projectId)
  return awaited.map((row) => (
    <Row key={`${row.kind} ${row.who} ${row.subject}`}>
      <span className="grow">
        <Person name={row.who || 'Designers'} picture={row.picture} role={roleOf(row.person_id)} />{' '}
        <span className="mid">{awaitedWords(row)}</span>
      </span>
      {row.since && <span className="dim num small nowrap">{age(row.since)}</span>}
    </Row>
  ))
}

/** For whom the current person waits. */
export function AwaitedCard({ awaited, projectId }: { awaited: readonly Awaited[]; projectId: string }) {
  if (awaited.length === 0) return null
  return (
    <Card aria-labelledby="awaited">
      <CardHead id="awaited" title="Waiting on others" end="since" />
      <Rows>
        <AwaitedRows awaited={awaited} projectId={projectId} />
      </Rows>
    </Card>
  )
}
