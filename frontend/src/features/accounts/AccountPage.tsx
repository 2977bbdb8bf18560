import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Row, Rows } from '@/ui/Rows'

import { type Me, meQuery, sessionQuery, useChangePassword, useOpenStudio, useRename } from './api'
import classes from './Account.module.css'
import { Field, Form } from './Form'
import { ROLE_WORDS } from './parts'
import { AddressCard, SignInsCard } from './SecurityCards'

const KIND_WORDS = { advisory: 'advises', contract: 'by contract', 'in-house': 'in-house' } as const

/** What one is in a project, in a word or two. */
function tieOf(project: Me['projects'][number]): string {
  if (project.part === 'designer') {
    return project.engagement_kind ? `sound designer, ${KIND_WORDS[project.engagement_kind]}` : 'sound designer'
  }
  if (project.is_decider) return 'approver'
  return project.is_liaison ? 'liaison' : 'team'
}

/** The person's own page: name, password, and everything they belong to. */
export function AccountPage() {
  useTitle('Account')
  const { data: me } = useQuery(meQuery)
  const { data: session } = useQuery(sessionQuery)
  if (me === undefined) return null
  return (
    <div className="page">
      <h1>Account</h1>
      <p className="mid">
        {me.person.name}, {me.email}
      </p>
      <div className={classes.cards}>
        <NameCard me={me} />
        {session?.demo !== true && <AddressCard me={me} />}
        <PasswordCard demo={session?.demo === true} />
        {session?.demo !== true && <SignInsCard />}
        <Card aria-labelledby="belong">
          <CardHead id="belong" title="Where you belong" />
          <Rows>
            {me.studios.map((studio) => (
              <Row key={studio.id}>
                <span className="strong grow">{studio.name}</span>
                <span className="small mid">{studio.roles.map((role) => ROLE_WORDS[role]).join(', ')}</span>
              </Row>
            ))}
            {me.projects.map((project) => (
              <Row key={project.id}>
                <span className="grow">
                  {project.name} <span className="small dim">{project.studio_name}</span>
                </span>
                <span className="small mid">{tieOf(project)}</span>
              </Row>
            ))}
            {me.studios.length + me.projects.length === 0 && (
              <Row>
                <span className="mid">
                  No studio and no project yet. A studio invites you by mail, or open your own.
                </span>
              </Row>
            )}
          </Rows>
        </Card>
        {session?.demo !== true && <StudioCard />}
      </div>
    </div>
  )
}

function NameCard({ me }: { me: Me }) {
  const rename = useRename()
  return (
    <Card aria-labelledby="name-card">
      <CardHead id="name-card" title="Name" note="as others see it" />
      <div className={classes.inside}>
        <Form
          action="Save the name"
          busy={rename.isPending}
          error={rename.error}
          onSubmit={(value) => {
            const before = me.person.name
            rename.mutate(value('name'), {
              onSuccess: ({ name }) => showToast(`You are ${name} now.`, () => rename.mutate(before)),
            })
          }}
        >
          <Field key={me.person.name} name="name" label="Your name" autoComplete="name" defaultValue={me.person.name} />
        </Form>
      </div>
    </Card>
  )
}

function PasswordCard({ demo }: { demo: boolean }) {
  const change = useChangePassword()
  const [round, setRound] = useState(0)
  if (demo) {
    return (
      <Card aria-labelledby="password-card">
        <CardHead id="password-card" title="Password" />
        <p className={`mid ${classes.inside} ${classes.note}`}>
          The people of the demo have none: this machine lets its visitor in without.
        </p>
      </Card>
    )
  }
  return (
    <Card aria-labelledby="password-card">
      <CardHead id="password-card" title="Password" note="a new one ends your other sign-ins" />
      <div className={classes.inside}>
        <Form
          key={round}
          action="Change the password"
          busy={change.isPending}
          error={change.error}
          onSubmit={(value) =>
            change.mutate(
              { current: value('current'), new: value('new') },
              {
                onSuccess: () => {
                  setRound(round + 1)
                  showToast('The password is changed; your other sign-ins have ended.')
                },
              },
            )
          }
        >
          <Field name="current" label="Password now" type="password" autoComplete="current-password" />
          <Field
            name="new"
            label="New password"
            type="password"
            autoComplete="new-password"
            hint="10 characters or more; four unrelated words make a good one."
          />
        </Form>
      </div>
    </Card>
  )
}

function StudioCard() {
  const open = useOpenStudio()
  const [round, setRound] = useState(0)
  return (
    <Card aria-labelledby="studio-card">
      <CardHead id="studio-card" title="Open a studio" note="with you as its producer" />
      <div className={classes.inside}>
        <Form
          key={round}
          action="Open the studio"
          busy={open.isPending}
          error={open.error}
          onSubmit={(value) =>
            open.mutate(value('name'), {
              onSuccess: ({ name }) => {
                setRound(round + 1)
                showToast(`${name} is open.`)
              },
            })
          }
        >
          <Field name="name" label="Name of the studio" autoComplete="organization" />
        </Form>
      </div>
    </Card>
  )
}
