import { Link } from '@tanstack/react-router'

import { useRoles } from '@/api/roles'
import { Card, CardHead } from '@/ui/Card'
import { AwaitedRows } from '@/app/NextCard'
import type { Awaited } from '@/app/nextSteps'
import { age, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Person } from '@/ui/Person'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import type { TodayAnswer } from './api'
import classes from './Today.module.css'

const SHOWN = 6

interface WithOthersProps {
  waiting: TodayAnswer['with_others']
  awaited: readonly Awaited[]
  projectId: string
}

/** What waits for another person. */
export function WithOthersCard({ waiting, awaited, projectId }: WithOthersProps) {
  const roleOf = useRoles(projectId)
  const shown = waiting.slice(0, SHOWN)
  // Sounds with designers stand line by line below, and cues with the approver in the list beside.
  const others = awaited.filter(({ kind }) => kind !== 'fixes' && kind !== 'verdicts')
  return (
    <Card aria-labelledby="others">
      <CardHead
        id="others"
        title="Waiting on others"
        count={waiting.length > SHOWN ? waiting.length : undefined}
        end="no action needed"
      />
      {waiting.length + others.length === 0 && <p className="p-10px-inset mid">Nothing is with a designer.</p>}
      <Rows>
        <AwaitedRows awaited={others} projectId={projectId} />
        {shown.map((item) => (
          <Row key={`${item.file_name} ${item.since}`}>
            <span className="grow">
              <span className="cut-text block">{item.cue?.name ?? item.file_name}</span>
              <span className="row small">
                <Person name={item.who} picture={item.picture} role={roleOf(item.person_id)} />
                <span className="dim nowrap">{age(item.since)}</span>
              </span>
            </span>
            <StatusBadge kind={item.status}>
              {item.status === 'unmatched' ? 'File without a cue' : undefined}
            </StatusBadge>
          </Row>
        ))}
      </Rows>
      {waiting.length > shown.length && (
        <p className="p-10px-inset small dim">and {waiting.length - shown.length} more</p>
      )}
    </Card>
  )
}

function Whose({ name, who, since }: { name: string; who: string; since: string }) {
  return (
    <span className="grow">
      <span className="cut-text block">{name}</span>
      <span className="small dim cut-text block">
        {who}, {age(since)}
      </span>
    </span>
  )
}

const buildName = (label: string): string => (/^[\d.]+$/.test(label) ? `Build ${label}` : label)

/** What the game's machine said of the last builds. */
export function Builds({ builds }: { builds: TodayAnswer['builds'] }) {
  if (builds.length === 0) return null
  return (
    <Card aria-labelledby="builds">
      <CardHead id="builds" title="Builds" end="checked by the game's machine" />
      <Rows>
        {builds.map((build) => (
          <Row key={build.id}>
            <Whose name={buildName(build.label)} who={build.target} since={build.created_at} />
            {build.rejected > 0 ? (
              <StatusBadge kind="refused">Refused, {plural(build.rejected, 'file')}</StatusBadge>
            ) : (
              <StatusBadge kind="passed">{`Passed, ${plural(build.files, 'file')}`}</StatusBadge>
            )}
          </Row>
        ))}
      </Rows>
    </Card>
  )
}

interface PlaceholdersProps {
  count: number
  mails: number
  projectId: string
}

/** What must be gone before the game ships, and what has not left the house. */
export function Placeholders({ count, mails, projectId }: PlaceholdersProps) {
  if (count === 0 && mails === 0) return null
  return (
    <Card aria-label="Reminders">
      <Rows>
        {count > 0 && (
          <Row>
            <span className={`tone-warn flex ${classes.sign}`}>
              <Icon name="dashedSquare" />
            </span>
            <span className="grow">{plural(count, 'cue plays', 'cues play')} a placeholder. It must not ship.</span>
            <Link to="/projects/$projectId/sound-list" params={{ projectId }} search={{}} className="link small">
              Sound list
            </Link>
          </Row>
        )}
        {mails > 0 && (
          <Row>
            <Icon name="mail" />
            <span className="grow">{plural(mails, 'email waiting', 'emails waiting')} to be sent.</span>
            <Link to="/studio" className="link small">
              Emails
            </Link>
          </Row>
        )}
      </Rows>
    </Card>
  )
}
