import { useQuery } from '@tanstack/react-query'
import { useParams, useRouter } from '@tanstack/react-router'

import { meQuery } from '@/api/me'
import { useTitle } from '@/app/title'
import { day } from '@/ui/format'

import { sessionQuery, studioInvitationQuery, useJoinStudio } from './api'
import { Field, Form, Submit } from '@/ui/Form'
import { Sheet } from '@/ui/Sheet'
import { Refusal } from '@/ui/Refusal'
import { ROLE_MEANINGS, ROLE_WORDS } from './parts'

/** The page of a mailed link into a studio. */
export function JoinPage() {
  useTitle('Invitation')
  const { secret } = useParams({ from: '/guest/join/$secret' })
  const router = useRouter()
  const { data: invitation, error } = useQuery(studioInvitationQuery(secret))
  const { data: session } = useQuery(sessionQuery)
  const { data: me } = useQuery({ ...meQuery, enabled: session?.signed_in === true })
  const joining = useJoinStudio(secret)

  if (error) {
    return (
      <Sheet>
        <h1>Invitation</h1>
        <Refusal error={error} fix="Ask the person who invited you for a new link." />
      </Sheet>
    )
  }
  if (invitation === undefined || session === undefined) return <Sheet>{null}</Sheet>
  const isThem = me?.email === invitation.email
  return (
    <Sheet>
      <h1>Join {invitation.studio_name}</h1>
      <p className="mid">
        {invitation.invited_by_name} invites {invitation.email}, until {day(invitation.expires_at)}.
      </p>
      <ul style={{ marginTop: 'var(--sl-3)' }}>
        {invitation.roles.map((role) => (
          <li key={role}>
            <span className="strong">{ROLE_WORDS[role]}</span> <span className="mid">{ROLE_MEANINGS[role]}</span>
          </li>
        ))}
      </ul>
      <Form
        initialValues={{ name: '', password: '' }}
        mutation={joining}
        onSubmit={({ name, password }) =>
          joining.mutate(
            { name: invitation.has_account ? null : name, password: isThem ? null : password },
            { onSuccess: () => void router.navigate({ href: '/' }) },
          )
        }
      >
        {!invitation.has_account && <Field name="name" label="Your name" autoComplete="name" />}
        {!isThem && (
          <Field
            name="password"
            label="Password"
            type="password"
            autoComplete={invitation.has_account ? 'current-password' : 'new-password'}
            description={invitation.has_account ? `The password of ${invitation.email}.` : 'At least 10 characters.'}
          />
        )}
        <Submit>Join {invitation.studio_name}</Submit>
      </Form>
    </Sheet>
  )
}
