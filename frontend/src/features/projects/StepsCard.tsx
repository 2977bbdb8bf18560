import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps } from '@tanstack/react-router'

import { ButtonLink } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { figure, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { NeedSums } from '@/ui/NeedSums'
import { StatusBadge, STATES } from '@/ui/StatusBadge'

import { type Overview, type Project, type Step } from './api'
import { invitationsQuery } from './people/api'
import classes from './Steps.module.css'
import { groupsOf, standInWords, type Status, STATUSES } from './steps'
import { canActForStudio } from './words'

interface StepsCardProps {
  project: Project
  overview: Overview
}

/** One cell a cue with the state it is in, the palette first. */
export function StepsCard({ project, overview: { steps, cues, counts, needs } }: StepsCardProps) {
  if (steps.length === 0) return <NothingAsked project={project} />
  const statuses = (Object.keys(STATUSES) as Status[]).filter((status) => (counts[status] ?? 0) > 0)
  return (
    <Card className={classes.card} aria-labelledby="steps">
      <div className={`flex wrap items-baseline between gap-2px-4 ${classes.head}`}>
        <h2 id="steps">{plural(cues, 'cue')}</h2>
        <p className="small mid">{standInWords(counts)}</p>
        <NeedSums sums={needs} />
      </div>
      <div className={`flex gap-14px ${classes.steps}`}>
        {groupsOf(steps).map((group) => (
          <div key={group.title} style={{ flexGrow: group.steps.length }} className={`min-w-0 ${classes.group}`}>
            <ul className={`flex wrap gap-3px ${classes.cells}`} aria-label={group.title}>
              {group.steps.map((step) => (
                <Cell key={step.cue.id} step={step} project={project} />
              ))}
            </ul>
            <p className="row between small">
              <span className="strong">{group.title}</span>
              <span className="mid nowrap">{`${group.accepted} of ${group.wanted} accepted`}</span>
            </p>
          </div>
        ))}
      </div>
      {cues > steps.length && (
        <p className={`small mid border-t ${classes.next}`}>
          The first {figure(steps.length)} in list order.{' '}
          <Link className="link" to={`/projects/${project.id}/sound-list` as LinkProps['to']}>
            All {figure(cues)} in the sound list
          </Link>
        </p>
      )}
      <ul className={`flex wrap border-t mt-3 text-small ${classes.legend}`} aria-label="Cues by state">
        {statuses.map((status) => (
          <li key={status}>
            <StatusBadge kind={STATUSES[status].kind}>
              {STATUSES[status].word} <span className={`ink ${classes.count}`}>{figure(counts[status] ?? 0)}</span>
            </StatusBadge>
          </li>
        ))}
      </ul>
      {canActForStudio(project) && <NobodyMakes project={project} />}
    </Card>
  )
}

function Cell({ step: { cue, status }, project }: { step: Step; project: Project }) {
  const { kind, word } = STATUSES[status]
  const { tone, icon } = STATES[kind]
  const says = `${cue.label} ${cue.name}: ${word}`
  // Other parts of the work stand there, so the address is not known by type.
  const to = (
    status === 'to_review' && project.mine.is_team
      ? `/projects/${project.id}/review/${cue.id}`
      : `/projects/${project.id}/sound-list/cues/${cue.id}`
  ) as LinkProps['to']
  return (
    <li>
      <Link to={to} className={`${classes.cell} tone-${tone}`} data-status={status} title={says} aria-label={says}>
        <Icon name={icon} />
      </Link>
    </li>
  )
}

/** A list without a designer. */
function NobodyMakes({ project }: { project: Project }) {
  const engaged = project.engagements.some(({ ended_at }) => ended_at === null)
  const { data: invitations } = useQuery({ ...invitationsQuery(project.id), enabled: !engaged })
  if (engaged || invitations === undefined) return null
  const open = invitations.filter(({ accepted_at }) => accepted_at === null)
  return (
    <p className={`row small border-t ${classes.next}`}>
      <Icon name="people" />
      {open.length === 0
        ? 'No designer yet'
        : `${plural(open.length, 'invitation')} not accepted yet: ${open.map(({ email }) => email).join(', ')}.`}
      <Link className="link end" to="/projects/$projectId/people" params={{ projectId: project.id }}>
        {open.length === 0 ? 'Invite a designer' : 'People'}
      </Link>
    </p>
  )
}

function NothingAsked({ project }: { project: Project }) {
  const list = `/projects/${project.id}/sound-list`
  if (!project.mine.is_team) {
    return <EmptyState head="No cues yet">The studio has not added cues yet. You get an email when it does.</EmptyState>
  }
  return (
    <EmptyState
      head="No cues yet"
      action={
        <>
          <ButtonLink component={Link} variant="primary" to={`${list}/import`}>
            Import cues
          </ButtonLink>
          <ButtonLink component={Link} to={list}>
            Write the list here
          </ButtonLink>
          <Link className="link" to="/projects/$projectId/people" params={{ projectId: project.id }}>
            Invite a designer
          </Link>
        </>
      }
    >
      First add cues, from a spreadsheet or one by one. Then invite a designer: the link shows the list and the delivery
      spec right away.
    </EmptyState>
  )
}
