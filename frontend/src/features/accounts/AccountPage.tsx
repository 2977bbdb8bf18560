import { useQuery } from '@tanstack/react-query'

import { type Me, meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { Card, CardHead } from '@/ui/Card'
import { Row, Rows } from '@/ui/Rows'

import { sessionQuery, useChangePassword, useOpenStudio, useRename } from './api'
import classes from './Account.module.css'
import { EraseCard } from './EraseCard'
import { Field, Form, Submit } from '@/ui/Form'
import { PageSkeleton } from '@/ui/Skeleton'
import { InvoiceDetailsCard } from './InvoiceDetailsCard'
import { ROLE_WORDS } from './parts'
import { PasskeysCard } from './PasskeysCard'
import { PictureCard } from './PictureCard'
import { SecondFactorCard } from './SecondFactorCard'
import { AddressCard, SignInsCard } from './SecurityCards'

const KIND_WORDS = { advisory: 'advises', contract: 'by contract', 'in-house': 'in-house' } as const

/** What one is in a project, in a word or two. */
function tieOf(project: Me['projects'][number]): string {
  if (project.part === 'designer') {
    return project.engagement_kind ? `sound designer, ${KIND_WORDS[project.engagement_kind]}` : 'sound designer'
  }
  if (project.is_approver) return 'approver'
  return project.is_liaison ? 'liaison' : 'team'
}

/** The person's own page: name, password, and everything they belong to. */
export function AccountPage() {
  useTitle('Account')
  const { data: me } = useQuery(meQuery)
  const { data: session } = useQuery(sessionQuery)
  if (me === undefined) return <PageSkeleton />
  const requiredBy = me.second_factor_required_by ?? []
  return (
    <div className="page">
      <h1>Account</h1>
      <p className="mid">
        {me.person.name}, {me.email}
      </p>
      {requiredBy.length > 0 && (
        <p role="status" className={`mt-4 p-3-4 border ${classes.required}`}>
          <span className="strong">{`${requiredBy.join(', ')}: a second factor is required.`}</span> Set one up below;
          then the studio’s pages open.
        </p>
      )}
      <div className={`grid items-start gap-4 mt-4 ${classes.cards}`}>
        <NameCard me={me} />
        <PictureCard me={me} />
        {session?.demo !== true && <AddressCard me={me} />}
        <PasswordCard demo={session?.demo === true} />
        {session?.demo !== true && <SecondFactorCard />}
        {session?.demo !== true && <PasskeysCard />}
        {session?.demo !== true && <SignInsCard />}
        <Card aria-labelledby="belong">
          <CardHead id="belong" title="Your studios and projects" />
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
                  You are not in a studio or project yet. Wait for an email invitation, or create your own studio.
                </span>
              </Row>
            )}
          </Rows>
        </Card>
        {me.projects.some(({ part }) => part === 'designer') && <InvoiceDetailsCard />}
        {session?.demo !== true && <StudioCard />}
        {session?.demo !== true && <EraseCard to="/erase/account" title="Erase your account" />}
      </div>
    </div>
  )
}

function NameCard({ me }: { me: Me }) {
  const rename = useRename()
  return (
    <Card aria-labelledby="name-card">
      <CardHead id="name-card" title="Name" note="shown to others" />
      <div className={classes.inside}>
        <Form
          key={me.person.name}
          initialValues={{ name: me.person.name }}
          mutation={rename}
          onSubmit={(values) =>
            rename.mutate(values.name, {
              onSuccess: ({ name }) => showToast(`Your name is now ${name}.`, () => rename.mutate(me.person.name)),
            })
          }
        >
          <Field name="name" label="Your name" autoComplete="name" />
          <Submit>Save name</Submit>
        </Form>
      </div>
    </Card>
  )
}

function PasswordCard({ demo }: { demo: boolean }) {
  const change = useChangePassword()
  if (demo) {
    return (
      <Card aria-labelledby="password-card">
        <CardHead id="password-card" title="Password" />
        <p className={`mid ${classes.inside} ${classes.note}`}>Demo accounts have no password.</p>
      </Card>
    )
  }
  return (
    <Card aria-labelledby="password-card">
      <CardHead
        id="password-card"
        title="Password"
        note="changing it signs you out everywhere else and ends your desk tokens"
      />
      <div className={classes.inside}>
        <Form
          initialValues={{ current: '', new: '' }}
          mutation={change}
          resets
          onSubmit={(values) =>
            change.mutate(values, {
              onSuccess: () =>
                showToast(
                  'Password changed. You are signed out on your other devices, and your desk tokens have ended.',
                ),
            })
          }
        >
          <Field name="current" label="Current password" type="password" autoComplete="current-password" />
          <Field
            name="new"
            label="New password"
            type="password"
            autoComplete="new-password"
            description="At least 10 characters. Four unrelated words make a good password."
          />
          <Submit>Change password</Submit>
        </Form>
      </div>
    </Card>
  )
}

function StudioCard() {
  const open = useOpenStudio()
  return (
    <Card aria-labelledby="studio-card">
      <CardHead id="studio-card" title="Create a studio" note="you become its producer" />
      <div className={classes.inside}>
        <Form
          initialValues={{ name: '' }}
          mutation={open}
          resets
          onSubmit={(values) => open.mutate(values.name, { onSuccess: ({ name }) => showToast(`${name} created.`) })}
        >
          <Field name="name" label="Studio name" autoComplete="organization" />
          <Submit>Create studio</Submit>
        </Form>
      </div>
    </Card>
  )
}
