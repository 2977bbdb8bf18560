import { Select, Textarea } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { mailedLinksQuery, MailedLink } from '@/mails'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { Avatar } from '@/ui/Avatar'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { ago, dueDay, shortDay } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Row, Rows } from '@/ui/Rows'
import { StatusBadge } from '@/ui/StatusBadge'

import { type Project } from '../api'
import {
  type Engagement,
  type EngagementKind,
  type Invitation,
  invitationsQuery,
  useChangeEngagement,
  useInviteDesigner,
  useRevokeInvitation,
} from './api'
import { KIND_MEANINGS, KIND_WORDS, KINDS, canActForStudio } from '../words'
import classes from './People.module.css'

const KIND_CHOICES = KINDS.map((kind) => ({ value: kind, label: `${KIND_WORDS[kind]}: ${KIND_MEANINGS[kind]}` }))
const isKind = (value: string | null): value is EngagementKind => KINDS.some((kind) => kind === value)

/** Who makes the sounds, who is asked to, and asking another. */
export function DesignersCard({ project }: { project: Project }) {
  const { data: invitations, error } = useQuery(invitationsQuery(project.id))
  const open = invitations?.filter(({ accepted_at }) => accepted_at === null) ?? []
  const may = canActForStudio(project)
  const nobody = project.engagements.length === 0 && invitations?.length === 0
  return (
    <Card aria-labelledby="designers">
      <CardHead id="designers" title="Designers" note="make and deliver the sounds" />
      {nobody && (
        <div className="p-inset">
          <EmptyState head="No designers yet" level={3}>
            The email invitation shows the sound list and the delivery spec right away, before signing up.
          </EmptyState>
        </div>
      )}
      <Rows aria-label="Designers">
        {project.engagements.map((engagement) => (
          <Designer key={engagement.id} engagement={engagement} project={project} />
        ))}
      </Rows>
      <Refusal inset error={error} />
      {open.length > 0 && <Invitations project={project} open={open} />}
      {may && <Invite project={project} first={nobody} />}
    </Card>
  )
}

function Designer({ engagement, project }: { engagement: Engagement; project: Project }) {
  const { id, designer, kind, created_at, ended_at } = engagement
  const change = useChangeEngagement(project.id)
  const ended = ended_at !== null
  const setEnded = (end: boolean) =>
    change.mutate(
      { id, ended: end },
      {
        onSuccess: () =>
          showToast(
            end
              ? `Engagement of ${designer.name} ended. Delivered work is kept.`
              : `Engagement of ${designer.name} resumed.`,
            () => change.mutate({ id, ended: !end }),
          ),
      },
    )
  return (
    <>
      <Row className={classes.person}>
        <Avatar name={designer.name} picture={designer.picture} />
        <div className="grow">
          <p className={ended ? 'struck' : 'strong'}>{designer.name}</p>
          <p className="small mid">
            {ended
              ? `${KIND_WORDS[kind]}, ${shortDay(created_at)} to ${shortDay(ended_at)}`
              : `${KIND_WORDS[kind]}, since ${shortDay(created_at)}`}
          </p>
        </div>
        {project.mine.is_producer && !ended && (
          <Select
            aria-label={`Engagement of ${designer.name}`}
            className={classes.kind}
            data={KINDS.map((value) => ({ value, label: KIND_WORDS[value] }))}
            value={kind}
            allowDeselect={false}
            onChange={(value) => {
              if (isKind(value) && value !== kind) change.mutate({ id, kind: value })
            }}
          />
        )}
        {project.mine.is_producer && (
          <Button
            variant="quiet"
            aria-label={`${ended ? 'Resume' : 'End'}: the engagement of ${designer.name}`}
            onClick={() => setEnded(!ended)}
          >
            {ended ? 'Resume' : 'End'}
          </Button>
        )}
      </Row>
      <Refusal inset error={change.error} />
    </>
  )
}

function Invitations({ project, open }: { project: Project; open: readonly Invitation[] }) {
  const revoke = useRevokeInvitation(project.id)
  const may = canActForStudio(project)
  const { data: mails } = useQuery({ ...mailedLinksQuery(project.id), enabled: may })
  const waitsHere = mails?.can_send === false
  return (
    <>
      <h3 className={`bg-surface mid text-small leading-small ${classes.part}`}>Pending invitations</h3>
      {waitsHere && (
        <p className={`row small tone-warn ${classes.hint}`}>
          <Icon name="triangle" />
          No mail server is set up. Copy the link and send it yourself.
        </p>
      )}
      <Refusal inset error={revoke.error} />
      <Rows aria-label="Pending invitations">
        {open.map(({ id, email, kind, note, inviter, created_at, expires_at }) => {
          const expired = new Date(expires_at) < new Date()
          return (
            <Row key={id} className={classes.person}>
              <Icon name="mail" />
              <div className="grow">
                <p className="strong wrap-anywhere">{email}</p>
                <p className="small mid">
                  {`${KIND_WORDS[kind]}, invited by ${inviter.name} ${ago(created_at)}; ${expired ? 'expired' : 'expires'} ${dueDay(expires_at)}`}
                </p>
                {note !== '' && <p className="small dim">{note}</p>}
              </div>
              {expired && <StatusBadge kind="late">Expired</StatusBadge>}
              {may && !expired && <MailedLink projectId={project.id} ofId={id} recipient={email} />}
              {may && (
                <Button
                  variant="quiet"
                  onClick={() =>
                    revoke.mutate(id, {
                      onSuccess: () => showToast(`Invitation to ${email} revoked.`),
                    })
                  }
                >
                  <span>
                    Revoke <span className="visually-hidden">{`the invitation to ${email}`}</span>
                  </span>
                </Button>
              )}
            </Row>
          )
        })}
      </Rows>
    </>
  )
}

const NEW_INVITATION: { email: string; kind: EngagementKind; note: string } = { email: '', kind: 'contract', note: '' }

function Invite({ project, first }: { project: Project; first: boolean }) {
  const invite = useInviteDesigner(project.id)
  return (
    <>
      <h3 className={`bg-surface mid text-small leading-small ${classes.part}`}>Invite a designer</h3>
      <DraftForm
        className={`grid gap-3 ${classes.invite}`}
        aria-label="Invite a designer"
        draftKey={`invite:${project.id}`}
        initialValues={NEW_INVITATION}
        mutation={invite}
        onSubmit={(typed, onSent) =>
          invite.mutate(typed, {
            onSuccess: (invitation) => {
              showToast(`${invitation.email} is invited.`)
              onSent()
            },
          })
        }
      >
        <Field name="email" label="Email" type="email" autoComplete="off" />
        <Field as={Select} name="kind" label="Engagement" data={KIND_CHOICES} allowDeselect={false} />
        <Field
          as={Textarea}
          optional
          className={classes.whole}
          name="note"
          label="Message (optional)"
          rows={2}
          resize="vertical"
        />
        <Submit
          variant={first ? 'primary' : 'plain'}
          className={`row wrap ${classes.whole}`}
          beside={
            <span className="small mid">The link shows the sound list, works for 30 days, and can be revoked.</span>
          }
        >
          Send invitation
        </Submit>
      </DraftForm>
    </>
  )
}
