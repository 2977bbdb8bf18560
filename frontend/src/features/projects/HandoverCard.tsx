import { useQuery } from '@tanstack/react-query'
import { queryById } from '@/api'
import { Link } from '@tanstack/react-router'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { day, plural } from '@/ui/format'

import classes from './Handover.module.css'

type OpenHandover = components['schemas']['OpenHandover']

const NAMED = 8

const handoversQuery = queryById('/v1/projects/{project_id}/handovers', (projectId) =>
  queryKeys.contracts(projectId, 'handovers'),
)

/** Cues of ended contracts that have no designer now: what the next one begins with, and how to hire them. */
export function HandoverCard({ projectId }: { projectId: string }) {
  const { data: handovers, error } = useQuery(handoversQuery(projectId))
  if (error) return <Refusal inset error={error} />
  return handovers?.map((handover) => <Handover key={handover.contract_id} handover={handover} projectId={projectId} />)
}

function Handover({ handover, projectId }: { handover: OpenHandover; projectId: string }) {
  const { contract_id: id, title, designer, ended_at: at, cues } = handover
  const head = `handover-${id}`
  const rest = cues.length - NAMED
  return (
    <Card aria-labelledby={head}>
      <CardHead
        id={head}
        title={`${plural(cues.length, 'cue')} ${cues.length === 1 ? 'has' : 'have'} no designer`}
        note={`${title} with ${designer} ended, ${day(at)}`}
      />
      <div className={`grid gap-3 p-3-4-4 ${classes.body}`}>
        <p>
          {cues
            .slice(0, NAMED)
            .map((cue) => `${cue.label} ${cue.name}`)
            .join(', ')}
          {rest > 0 && ` and ${rest} more`}
        </p>
        <p className="mid">
          You are next: invite a designer, or write the next contract with one who is here. Its proposed plan begins
          with these cues. The designer hears the approved sounds and the palette.
        </p>
        <div className="flex wrap gap-2">
          <ButtonLink component={Link} variant="primary" to={`/projects/${projectId}/contracts`}>
            Write the next contract
          </ButtonLink>
          <ButtonLink component={Link} to={`/projects/${projectId}/people`}>
            Invite a designer
          </ButtonLink>
          <ButtonLink
            variant="quiet"
            icon="download"
            href={`/v1/contracts/${id}/handover`}
            download
            aria-label={`Download handover pack of ${title}`}
          >
            Download handover pack
          </ButtonLink>
        </div>
      </div>
    </Card>
  )
}
