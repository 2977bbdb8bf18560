import { useQuery } from '@tanstack/react-query'
import { Link, type LinkProps, useNavigate, useParams } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { ApiProblem } from '@/api'
import { useIsParty } from '@/api/me'
import { overviewQuery, projectQuery, studioPeopleQuery } from '@/api/project'
import { useHotkeys } from '@/app/keys'
import { awaitedWords, nextStepsQuery, wordsOf } from '@/app/nextSteps'
import { NotFoundPage } from '@/app/NotFoundPage'
import { useTitle } from '@/app/title'
import { moneyQuery } from '@/money/api'
import { money } from '@/money/words'
import { ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Avatar } from '@/ui/Avatar'
import { age, figure, plural, shortDay } from '@/ui/format'
import { Key } from '@/ui/Key'
import { Meter } from '@/ui/Meter'
import { Refusal } from '@/ui/Refusal'
import { PageSkeleton, Skeleton } from '@/ui/Skeleton'
import { StatusBadge, STATES } from '@/ui/StatusBadge'

import { packsQuery, type Project } from './api'
import classes from './Overview.module.css'
import { PhasesCard } from './PhasesCard'
import { PlaylistsCard } from './PlaylistsCard'
import { type Status, STATUSES } from './steps'
import { KIND_WORDS, otherMembers } from './words'

/** A project at one glance: the next step, and four cards that lead on, each by its number. */
export function ProjectPage() {
  useTitle('Overview')
  const { projectId } = useParams({ from: '/shell/projects/$projectId' })
  const { data: project, error } = useQuery(projectQuery(projectId))
  const isParty = useIsParty(projectId)
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  if (project === undefined && error === null) return <PageSkeleton />
  return (
    <div className="page">
      <h1>{project?.name ?? 'Project'}</h1>
      <p className="mid mb-4">{project?.description}</p>
      {project?.archived_at && (
        <p className="mid">
          This project is archived. It is read-only in lists of active projects and can be restored.
        </p>
      )}
      <Refusal inset error={error} />
      {project && (
        <>
          <NextStep projectId={projectId} />
          <div className={`grid gap-4 grid-cols-1fr-1fr mt-4 ${classes.cards}`}>
            <SoundsCard projectId={projectId} />
            <PeopleCard project={project} />
            {isParty && <MoneyCard projectId={projectId} />}
            {project.mine.is_team ? <NextPackCard projectId={projectId} /> : <PlaylistsCard projectId={projectId} />}
          </div>
          <PhasesCard projectId={projectId} />
        </>
      )}
    </div>
  )
}

/** What the reader does next, with its button; the steps after it are named. */
function NextStep({ projectId }: { projectId: string }) {
  const navigate = useNavigate()
  const { data: next } = useQuery(nextStepsQuery(projectId))
  const [first, ...others] = (next?.steps ?? []).map((step) => wordsOf(step, projectId))
  useHotkeys(
    first
      ? [{ keys: 'Enter', label: first.act, group: 'Overview', run: () => void navigate({ href: first.path }) }]
      : [],
  )
  if (next === undefined) return <Skeleton />
  if (first === undefined) return null
  return (
    <section className={`flex wrap items-center gap-3 bg-raised p-3-4 rounded ${classes.next}`} aria-label="Next step">
      <div className="grow">
        <p className="strong">{first.head}</p>
        <p className="small mid">
          {first.why}
          {others.length > 0 && ` Then: ${others.map(({ head }) => head).join('. ')}.`}
        </p>
      </div>
      <ButtonLink component={Link} to={first.path} variant="primary" keys="Enter">
        {first.act}
      </ButtonLink>
    </section>
  )
}

interface OverviewCardProps {
  title: string
  note?: string
  /** Where the card's subject is shown in full, and the key that opens it. */
  link: { label: string; to: string; keys: string }
  error: unknown
  children: ReactNode
}

/** One card; while its figures are asked for, and where they could not be read, its head stands. */
function OverviewCard({ title, note, link, error, children }: OverviewCardProps) {
  const id = `overview-${title.toLowerCase().replace(' ', '-')}`
  const navigate = useNavigate()
  useHotkeys([{ keys: link.keys, label: link.label, group: 'Overview', run: () => void navigate({ href: link.to }) }])
  return (
    <Card aria-labelledby={id}>
      <CardHead
        id={id}
        title={title}
        note={note}
        end={
          <span className="row">
            <Link className="link small" to={link.to as LinkProps['to']} aria-keyshortcuts={link.keys}>
              {link.label}
            </Link>
            <Key keys={link.keys} />
          </span>
        }
      />
      <Refusal inset error={error} />
      <div className="grid gap-10px p-3-inset">{children ?? (error ? null : <Skeleton />)}</div>
    </Card>
  )
}

function SoundsCard({ projectId }: { projectId: string }) {
  const { data: overview, error } = useQuery(overviewQuery(projectId))
  const { data: earned } = useQuery({ ...moneyQuery(projectId), enabled: useIsParty(projectId) })
  const counts = overview?.counts ?? {}
  const statuses = (Object.keys(STATUSES) as Status[]).filter((status) => (counts[status] ?? 0) > 0)
  const milestones = (earned?.contracts ?? []).flatMap((contract) => contract.milestones).filter((m) => !m.is_deposit)
  const words = statuses.map((status) => `${counts[status]} ${STATUSES[status].word.toLowerCase()}`).join(', ')
  return (
    <OverviewCard
      title="Sounds"
      link={{ label: 'Open list', to: `/projects/${projectId}/sound-list`, keys: '1' }}
      error={error}
    >
      {overview && (
        <>
          <p>
            <span
              className={classes.figure}
            >{`${counts.accepted ?? 0} of ${figure(overview.cues - (counts.cut ?? 0))}`}</span>{' '}
            <span className="mid">{`accepted${counts.cut ? `; ${counts.cut} cut` : ''}`}</span>
          </p>
          <Meter
            label={words || 'No cues yet'}
            whole={overview.cues - (counts.cut ?? 0)}
            parts={statuses
              .filter((status) => !['to_make', 'cut'].includes(status))
              .map((status) => ({ value: counts[status] ?? 0, tone: STATES[STATUSES[status].kind].tone }))}
          />
          <ul className="small flex wrap gap-1-4" aria-label="Cues by state">
            {statuses.map((status) => (
              <li key={status}>
                <StatusBadge
                  kind={STATUSES[status].kind}
                >{`${counts[status]} ${STATUSES[status].word.toLowerCase()}`}</StatusBadge>
              </li>
            ))}
          </ul>
          <ul className={classes.rows} aria-label="Milestones">
            {milestones.slice(0, 4).map(({ id, name, accepted, wanted, due_on, done_at }) => (
              <li key={id}>
                <span className="strong">{name}</span>
                <span className="mid grow">{`${accepted} of ${wanted}`}</span>
                <span className="small dim">{done_at ? 'done' : due_on ? shortDay(due_on) : ''}</span>
              </li>
            ))}
          </ul>
        </>
      )}
    </OverviewCard>
  )
}

/** The people who decide and make, and what each is awaited for. */
function PeopleCard({ project }: { project: Project }) {
  const { id: projectId, approver, mine, studio } = project
  const { data: members, error } = useQuery({ ...studioPeopleQuery(studio.id), enabled: mine.is_team })
  const { data: next } = useQuery(nextStepsQuery(projectId))
  const producers = (members ?? []).filter(
    ({ roles, person }) => roles.includes('producer') && person.id !== approver.id,
  )
  const designers = project.engagements.filter(({ ended_at }) => ended_at === null)
  const people = [
    { ...approver, part: 'Approver' },
    ...producers.map(({ person }) => ({ ...person, part: 'Producer' })),
    ...designers.map(({ designer, kind }) => ({ ...designer, part: `Sound designer, ${KIND_WORDS[kind]}` })),
  ]
  const others = (members?.length ?? 0) - (people.length - designers.length)
  const link = mine.is_team
    ? { label: 'Open team', to: `/projects/${projectId}/people`, keys: '2' }
    : { label: 'Credits', to: `/projects/${projectId}/credits`, keys: '2' }
  return (
    <OverviewCard title="People" link={link} error={error}>
      <ul className={classes.rows} aria-label="People">
        {people.map(({ id, name, picture, part }) => {
          const awaited = next?.awaited.find(({ person_id }) => person_id === id)
          return (
            <li key={id}>
              <Avatar name={name} picture={picture} />
              <span className="strong">{name}</span>
              <span className="small dim">{part}</span>
              <span className={`small mid ${classes.awaited}`}>
                {awaited && `${awaitedWords(awaited)}${awaited.since ? `, ${age(awaited.since)}` : ''}`}
              </span>
            </li>
          )
        })}
        {mine.is_team && others > 0 && <li className="mid">{otherMembers(others)}</li>}
        {designers.length === 0 && <li className="mid">No designer yet</li>}
      </ul>
    </OverviewCard>
  )
}

function MoneyCard({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(moneyQuery(projectId))
  return (
    <OverviewCard
      title="Money"
      link={{ label: 'Open invoices', to: `/projects/${projectId}/money`, keys: '3' }}
      error={error}
    >
      {data?.totals.length === 0 && <p className="mid">No signed contract yet.</p>}
      {data?.totals.map(({ currency, figures: { paid_minor, agreed_minor, due_minor, open_minor } }) => (
        <div key={currency} className="stack">
          <p>
            <span className={classes.figure}>{money(paid_minor, currency)}</span>{' '}
            <span className="mid">paid of {money(agreed_minor, currency)}</span>
          </p>
          <Meter
            label={`${money(paid_minor, currency)} paid, ${money(due_minor, currency)} due`}
            whole={agreed_minor}
            parts={[{ value: paid_minor }, { value: due_minor, tone: 'idle' }]}
          />
          <p className="small mid">
            <span className="strong">{money(due_minor, currency)}</span> due,{' '}
            <span className="strong">{money(open_minor, currency)}</span> still open
          </p>
        </div>
      ))}
    </OverviewCard>
  )
}

function NextPackCard({ projectId }: { projectId: string }) {
  const { data: packs, error } = useQuery(packsQuery(projectId))
  const { data: overview } = useQuery(overviewQuery(projectId))
  const isWithoutTarget = error instanceof ApiProblem && error.code === 'target-unknown'
  const refused = overview?.builds[0]?.rejected ?? 0
  const [pack] = packs ?? []
  return (
    <OverviewCard
      title="Next pack"
      link={{ label: 'Open packs', to: `/projects/${projectId}/packs`, keys: '4' }}
      error={isWithoutTarget ? null : error}
    >
      {isWithoutTarget && <p className="mid">The spec has no targets, so no game files are rendered.</p>}
      {pack && (
        <>
          <p>
            <span className={classes.figure}>{plural(pack.files, 'file')}</span>{' '}
            <span className="mid">{`of ${plural(pack.cues_accepted, 'accepted cue')}, for ${pack.target}`}</span>
          </p>
          {pack.missing.length > 0 && (
            <StatusBadge kind="warning">{`${plural(pack.missing.length, 'accepted file')} missing`}</StatusBadge>
          )}
        </>
      )}
      {overview && overview.builds.length > 0 && (
        <p className="small mid">
          {`Build ${overview.builds[0]?.label}: ${refused === 0 ? 'no file refused' : `${plural(refused, 'file')} refused`}`}
        </p>
      )}
    </OverviewCard>
  )
}
