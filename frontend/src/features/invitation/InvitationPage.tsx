import { useQuery } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import { useRef, useState } from 'react'

import { visitorQuery } from '@/api/me'
import { ShellLink } from '@/app/shell/ShellLink'
import { useTitle } from '@/app/title'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { type Column, ListTable } from '@/ui/Table'
import { EmptyState } from '@/ui/EmptyState'
import { day, lengthAsked, plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'
import { PageSkeleton } from '@/ui/Skeleton'
import { Refusal } from '@/ui/Refusal'

import { type Invitation, invitationQuery, type PreviewCue } from './api'
import classes from './Invitation.module.css'
import { StartForm } from './StartForm'
import { factsOf, KIND_WORDS, shapeOf, sumOf } from './words'

/** What a mailed link shows: the project, its list and how sounds must come, before any account. */
export function InvitationPage() {
  useTitle('Invitation')
  const { secret } = useParams({ from: '/guest/invitation/$secret' })
  const { data: invitation, error } = useQuery(invitationQuery(secret))
  if (error) {
    return (
      <div className="page page-narrow">
        <h1>Invitation</h1>
        <Refusal error={error} fix="Ask the person who invited you for a new link." />
      </div>
    )
  }
  if (invitation === undefined) return <PageSkeleton />
  return <Shown secret={secret} invitation={invitation} />
}

function Shown({ secret, invitation }: { secret: string; invitation: Invitation }) {
  const { project, studio_name: studio, invited_by_name: inviter, kind, note, cues, spec, expires_at } = invitation
  const { data: visitor } = useQuery(visitorQuery)
  const [starting, setStarting] = useState(false)
  const startRef = useRef<HTMLDivElement>(null)
  const sum = sumOf(cues)
  const isIn = invitation.accepted && visitor?.email === invitation.email
  const desk = visitor?.projects.find(({ name, studio_name }) => name === project.name && studio_name === studio)
  const start = () => {
    setStarting(true)
    requestAnimationFrame(() => startRef.current?.scrollIntoView({ block: 'nearest' }))
  }

  return (
    <div className="page">
      <div className={`flex wrap items-start between mb-4 ${classes.head}`}>
        <div>
          <h1>{project.name}</h1>
          <p className="mid">
            {inviter} of {studio} invites you {KIND_WORDS[kind]}.
          </p>
          {project.description && <p className="mt-2 wrap-anywhere pre-line">{project.description}</p>}
        </div>
        {isIn && desk ? (
          <ButtonLink component={ShellLink} variant="primary" icon="tray" path={`/projects/${desk.id}/desk`}>
            Go to your desk
          </ButtonLink>
        ) : (
          !starting && (
            <Button variant="primary" icon="upload" className={classes.start} onClick={start}>
              Start delivering
            </Button>
          )
        )}
      </div>
      {note && (
        <blockquote className={`pre-line wrap-anywhere mb-4 ${classes.note}`}>
          <p className="lead">{note}</p>
          <footer className="small dim">{inviter}</footer>
        </blockquote>
      )}
      {starting && (
        <div ref={startRef}>
          <StartForm
            secret={secret}
            invitation={invitation}
            visitor={visitor ?? null}
            onBack={() => setStarting(false)}
          />
        </div>
      )}
      <div className={`columns ${classes.columns}`}>
        <section aria-labelledby="list">
          <div className="flex items-baseline gap-3 min-h-28px">
            <h2 id="list">Sound list</h2>
            {!invitation.nda_needed && (
              <span className="small dim">
                {plural(sum.cues, 'cue')}, {plural(sum.files, 'file')}
                {sum.settled < sum.cues && `, ${sum.cues - sum.settled} not final yet`}
              </span>
            )}
          </div>
          {invitation.nda_needed ? (
            <div className="p-inset">
              <EmptyState head="Sign the NDA to see the sound list" level={3}>
                “Start delivering” creates your account. The NDA is then under Contract & money. You see the sound list
                and spec once both sides have signed.
              </EmptyState>
            </div>
          ) : cues.length === 0 ? (
            <div className="p-inset">
              <EmptyState head="The sound list is empty" level={3}>
                You get an email when there is something to do.
              </EmptyState>
            </div>
          ) : (
            <ListTable
              label="Sound list"
              columns={COLUMNS}
              groups={[{ id: 'all', rows: cues }]}
              keyOf={({ number }) => String(number)}
            />
          )}
        </section>
        <div className="stack">
          {spec && (
            <Card aria-labelledby="spec">
              <CardHead id="spec" title="File requirements" note={spec.name} />
              <dl className={classes.facts}>
                {factsOf(spec).map(({ term, text }) => (
                  <div key={term}>
                    <dt>{term}</dt>
                    <dd>{text}</dd>
                  </div>
                ))}
              </dl>
              <p className="small mid border-t p-10px-inset">
                Files that don’t meet them are returned at once, with what was found and how to fix it. That does not
                count as a revision round.
              </p>
            </Card>
          )}
          <p className="small dim">The link works until {day(expires_at)}. Anyone with the link can see this page.</p>
        </div>
      </div>
    </div>
  )
}

const COLUMNS: Column<PreviewCue>[] = [
  {
    id: 'number',
    head: 'Cue ID',
    width: '76px',
    cell: ({ label }) => <span className="mono dim">{label}</span>,
  },
  {
    id: 'name',
    head: 'Name',
    width: '22%',
    narrow: 'name',
    rowHead: true,
    cell: ({ name, state }) => <span className={state === 'cut' ? 'struck' : 'strong'}>{name}</span>,
  },
  { id: 'category', head: 'Category', width: '90px', cell: ({ category }) => <span className="mid">{category}</span> },
  {
    id: 'use',
    head: 'Use and description',
    narrow: 'stands',
    cell: ({ use, description }) => (
      <span className={`mid block wrap-anywhere ${classes.offer}`}>
        {[use, description].filter(Boolean).join('. ')}
      </span>
    ),
  },
  {
    id: 'length',
    head: 'Length',
    width: '72px',
    numeric: true,
    cell: lengthAsked,
  },
  {
    id: 'set',
    head: 'Set, loop',
    width: '104px',
    narrow: 'set',
    cell: (cue) => <span className="small mid">{shapeOf(cue)}</span>,
  },
  {
    id: 'state',
    head: 'Status',
    width: '104px',
    narrow: 'state',
    cell: ({ state }) => {
      if (state === 'concept') return <StatusBadge kind="warning">Concept</StatusBadge>
      if (state === 'cut') return <StatusBadge kind="cut" />
      return <span className="small mid">{state === 'locked' ? 'Locked' : 'Prototype'}</span>
    },
  },
]
