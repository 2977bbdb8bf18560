import { Select } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { meQuery } from '@/api/me'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { MailedLink } from '@/mails'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Avatar } from '@/ui/Avatar'
import { Field, Form, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { shortDay } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'
import { sentence } from '@/ui/sentence'

import { type Project } from '../api'
import { approverHistoryQuery, invitedApproversQuery, type Member, useInviteApprover, useNameApprover } from './api'
import { candidatesOf } from './candidates'
import classes from './People.module.css'

/** The approver, why, and the former approvers. */
export function ApproverCard({ project, members = [] }: { project: Project; members: readonly Member[] | undefined }) {
  const { data: me } = useQuery(meQuery)
  const { data: history, error } = useQuery(approverHistoryQuery(project.id))
  const [naming, setNaming] = useState<string | null>(null)
  const name = useNameApprover(project.id)
  const { approver, mine } = project
  const candidates = candidatesOf(project, members).filter(({ person }) => person.id !== approver.id)
  const own = candidates.find(({ person }) => person.id === me?.person.id)
  return (
    <Card aria-labelledby="approver">
      <CardHead id="approver" title="Approver" note={ofWhat(project)} />
      <div className="flex items-center gap-3 p-2-inset">
        <Avatar name={approver.name} picture={approver.picture} filled />
        <div className="grow">
          <p className="strong">{approver.name}</p>
          {history?.[0] && (
            <p className="small mid">{`since ${shortDay(history[0].created_at)}: ${sentence(history[0].reason)}`}</p>
          )}
        </div>
      </div>
      {mine.is_producer && naming === null && (
        <div className={`row wrap ${classes.acts}`}>
          {candidates.length > 0 && (
            <Button onClick={() => setNaming(candidates[0]?.person.id ?? null)}>Change approver</Button>
          )}
          {own && (
            <Button variant="quiet" onClick={() => setNaming(own.person.id)}>
              Make me the approver
            </Button>
          )}
        </div>
      )}
      {naming !== null && candidates.length > 0 && (
        <DraftForm
          className="grid gap-3 p-3-inset-4"
          aria-label="Change the approver"
          draftKey={`approver:${project.id}`}
          initialValues={{ person_id: naming, reason: '' }}
          mutation={name}
          onSubmit={(typed, onSent) =>
            name.mutate(typed, {
              onSuccess: (changed) => {
                showToast(`${changed.approver.name} is the approver now.`)
                setNaming(null)
                onSent()
              },
            })
          }
        >
          <Field
            as={Select}
            name="person_id"
            label="New approver"
            data={candidates.map(({ person }) => ({
              value: person.id,
              label: person.id === me?.person.id ? `${person.name} (you)` : person.name,
            }))}
            allowDeselect={false}
          />
          <Field optional name="reason" label="Reason (logged)" />
          <Submit onCancel={() => setNaming(null)}>Make approver</Submit>
        </DraftForm>
      )}
      {mine.is_producer && naming === null && <InviteApprover project={project} />}
      <Refusal inset error={error} />
      {history && history.length > 0 && (
        <>
          <h3 className={`bg-surface mid text-small leading-small ${classes.part}`}>Earlier approvers</h3>
          <Rows aria-label="Earlier approvers">
            {history.map(({ person, changer, reason: why, created_at }) => (
              <Row key={created_at} className={classes.had}>
                <span className="small dim nowrap">{shortDay(created_at)}</span>
                <p className="small grow">
                  <span className="strong">{person.name}</span>{' '}
                  <span className="mid">{`${person.id === changer.id ? 'took over' : `named by ${changer.name}`}: ${sentence(why)}`}</span>
                </p>
              </Row>
            ))}
          </Rows>
        </>
      )}
    </Card>
  )
}

/** What the project's approver approves: every sound, but for categories with an approver of their own. */
const ofWhat = ({ category_approvers: own }: Project): string =>
  own.length === 0 ? 'approves or returns every sound' : 'approves or returns every other sound'

/** An address becomes the approver in one step: a member at once, others when they join. */
function InviteApprover({ project }: { project: Project }) {
  const invite = useInviteApprover(project.id, project.studio.id)
  const { data: invited = [] } = useQuery(invitedApproversQuery(project.id, project.studio.id))
  return (
    <>
      <h3 className={`bg-surface mid text-small leading-small ${classes.part}`}>Invite an approver</h3>
      {invited.map((invitation) => (
        <div key={invitation.id} className={`row wrap ${classes.acts}`}>
          <span className="small mid">{invitation.email} is invited and becomes the approver on joining.</span>
          <MailedLink projectId={project.id} ofId={invitation.id} recipient={invitation.email} />
        </div>
      ))}
      <Form
        className="grid gap-3 p-3-inset-4"
        aria-label="Invite an approver"
        initialValues={{ email: '' }}
        mutation={invite}
        resets
        onSubmit={({ email }) =>
          invite.mutate(email, {
            onSuccess: (invitation) =>
              showToast(
                invitation.is_named ? `${invitation.email} is the approver now.` : `${invitation.email} is invited.`,
              ),
          })
        }
      >
        <Field name="email" label="Approver’s email" type="email" autoComplete="off" />
        <Submit variant="plain">Invite as approver</Submit>
      </Form>
    </>
  )
}
