import { Checkbox, Menu } from '@mantine/core'
import { useState } from 'react'

import { formDraft, keepDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Avatar } from '@/ui/Avatar'
import { age, day } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import {
  type Member,
  type Role,
  useFetchDeparture,
  useInvitations,
  useInvite,
  usePeople,
  useRemoveMember,
  useSetRoles,
  useWithdraw,
} from './api'
import { Field, Form, Submit } from '@/ui/Form'
import { CardProblem } from './CardProblem'
import { type Departure, DepartureDialog } from './DepartureDialog'
import { LEAD_ROLES, ROLE_MEANINGS, ROLE_WORDS, ROLES } from './parts'
import classes from './Studio.module.css'

const rolesInWords = (roles: readonly Role[]) =>
  ROLES.filter((role) => roles.includes(role))
    .map((role) => ROLE_WORDS[role])
    .join(', ')

interface PeopleCardProps {
  studioId: string
  meId: string
  isProducer: boolean
}

export function PeopleCard({ studioId, meId, isProducer }: PeopleCardProps) {
  const { data: people, error } = usePeople(studioId)
  const setRoles = useSetRoles(studioId)
  const remove = useRemoveMember(studioId)

  const departureOf = useFetchDeparture(studioId)
  const [departing, setDeparting] = useState<{ member: Member; roles: Role[] } | null>(null)

  const change = async (member: Member, roles: Role[]) => {
    if (roles.length === 0) return
    remove.reset()
    setRoles.reset()
    const loses = LEAD_ROLES.some((role) => member.roles.includes(role) && !roles.includes(role))
    if (loses && (await departureOf(member.person.id, roles)).length > 0) {
      setDeparting({ member, roles })
      return
    }
    setRoles.mutate(
      { personId: member.person.id, roles },
      {
        onSuccess: () =>
          showToast(`${member.person.name}: ${rolesInWords(roles)}.`, () =>
            setRoles.mutate({ personId: member.person.id, roles: member.roles }),
          ),
      },
    )
  }
  const confirm = ({ member, roles }: { member: Member; roles: Role[] }, { handOverTo, keep }: Departure) => {
    const name = member.person.name
    if (roles.length > 0) {
      setRoles.mutate(
        { personId: member.person.id, roles, handOverTo },
        {
          onSuccess: () => {
            setDeparting(null)
            showToast(`${name}: ${rolesInWords(roles)}.`)
          },
        },
      )
      return
    }
    remove.mutate(
      { personId: member.person.id, handOverTo, keep },
      {
        onSuccess: () => {
          setDeparting(null)
          showToast(`${name} was removed from the studio. Invite them again to bring them back.`)
        },
      },
    )
  }
  return (
    <Card aria-labelledby="people">
      <CardHead id="people" title="People" count={people?.length} note="designers are listed in their projects" />
      <CardProblem error={error ?? (departing ? null : setRoles.error)} />
      <Rows aria-labelledby="people">
        {people?.map((member) => (
          <Row key={member.person.id}>
            <Avatar name={member.person.name} picture={member.person.picture} />
            <span className="grow">
              <span className="strong">{member.person.name}</span>
              {member.person.id === meId && <span className="small dim"> you</span>}
              <br />
              <span className="small mid wrap-anywhere">{member.email}</span>
            </span>
            {isProducer ? (
              <RolesMenu
                member={member}
                onChange={(roles) => void change(member, roles).catch(() => undefined)}
                onRemove={() => {
                  setRoles.reset()
                  remove.reset()
                  setDeparting({ member, roles: [] })
                }}
              />
            ) : (
              <span className="small mid">{rolesInWords(member.roles)}</span>
            )}
          </Row>
        ))}
      </Rows>
      {departing && (
        <DepartureDialog
          studioId={studioId}
          meId={meId}
          member={departing.member}
          roles={departing.roles}
          error={setRoles.error ?? remove.error}
          busy={setRoles.isPending || remove.isPending}
          onConfirm={(departure) => confirm(departing, departure)}
          opened
          onClose={() => setDeparting(null)}
        />
      )}
    </Card>
  )
}

interface RolesMenuProps {
  member: Member
  onChange: (roles: Role[]) => void
  onRemove: () => void
}

function RolesMenu({ member, onChange, onRemove }: RolesMenuProps) {
  return (
    <Menu position="bottom-end" width={300} closeOnItemClick={false} transitionProps={{ duration: 0 }}>
      <Menu.Target>
        <Button variant="quiet" aria-label={`Roles of ${member.person.name}: ${rolesInWords(member.roles)}`}>
          {rolesInWords(member.roles)}
        </Button>
      </Menu.Target>
      <Menu.Dropdown>
        {ROLES.map((role) => {
          const has = member.roles.includes(role)
          return (
            <Menu.CheckboxItem
              key={role}
              checked={has}
              disabled={has && member.roles.length === 1}
              onChange={() => onChange(has ? member.roles.filter((other) => other !== role) : [...member.roles, role])}
            >
              <span className="strong">{ROLE_WORDS[role]}</span>
              <br />
              <span className="small mid">{ROLE_MEANINGS[role]}</span>
            </Menu.CheckboxItem>
          )
        })}
        <Menu.Divider />
        <Menu.Item closeMenuOnClick onClick={onRemove}>
          Remove from the studio…
        </Menu.Item>
      </Menu.Dropdown>
    </Menu>
  )
}

export function InvitationsCard({ studioId }: { studioId: string }) {
  const { data: invitations = [], error } = useInvitations(studioId, true)
  const invite = useInvite(studioId)
  const withdraw = useWithdraw(studioId)
  const [roles, setRoles] = useState<Role[]>(['reviewer'])
  return (
    <Card aria-labelledby="invite">
      <CardHead id="invite" title="Invite a team member" />
      <div className={classes.inside}>
        <p className="small mid" style={{ paddingTop: 'var(--sl-3)' }}>
          For the game team. Invite sound designers on the project’s People page.
        </p>
        <Form
          {...formDraft(`invite:${studioId}`, { email: '' })}
          mutation={invite}
          resets
          onSubmit={(values) =>
            invite.mutate(
              { ...values, roles },
              {
                onSuccess: ({ email }) => {
                  keepDraft(`invite:${studioId}`, null)
                  showToast(`${email} is invited.`)
                },
              },
            )
          }
        >
          <Field name="email" label="Email" type="email" autoComplete="off" />
          <Checkbox.Group label="Roles" value={roles} onChange={(chosen) => chosen.length > 0 && setRoles(chosen)}>
            <div className="grid gap-2 mt-1">
              {ROLES.map((role) => (
                <Checkbox
                  key={role}
                  value={role}
                  size="sm"
                  label={ROLE_WORDS[role]}
                  description={ROLE_MEANINGS[role]}
                />
              ))}
            </div>
          </Checkbox.Group>
          <Submit>Invite</Submit>
        </Form>
      </div>
      <CardProblem error={error ?? withdraw.error} />
      {invitations.length > 0 && (
        <Rows aria-label="Pending invitations">
          {invitations.map(({ id, email, roles: asked, created_at, expires_at }) => (
            <Row key={id}>
              <span className="grow">
                <span className="wrap-anywhere">{email}</span>
                <br />
                <span className="small mid">
                  {rolesInWords(asked)}, waits {age(created_at)}, until {day(expires_at)}
                </span>
              </span>
              <Button
                variant="quiet"
                aria-label={`Withdraw the invitation to ${email}`}
                onClick={() => withdraw.mutate(id, { onSuccess: () => showToast(`Invitation to ${email} withdrawn.`) })}
              >
                Withdraw
              </Button>
            </Row>
          ))}
        </Rows>
      )}
    </Card>
  )
}
