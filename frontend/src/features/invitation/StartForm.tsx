import { useRouter } from '@tanstack/react-router'

import type { components } from '@/api/schema.gen'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Form, Submit } from '@/ui/Form'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Invitation, useAccept } from './api'
import classes from './Invitation.module.css'

interface StartFormProps {
  secret: string
  invitation: Invitation
  visitor: components['schemas']['Me'] | null
  onBack: () => void
}

/** The account, asked for only now: so that files, verdicts and money have an owner. */
export function StartForm({ secret, invitation, visitor, onBack }: StartFormProps) {
  const router = useRouter()
  const accept = useAccept(secret)
  const { email, has_account: hasAccount, project } = invitation
  const isThem = visitor?.email === email
  const firstField = useFocusOnMount<HTMLInputElement>()
  return (
    <Card aria-labelledby="start" className={classes.form}>
      <CardHead
        id="start"
        title={isThem ? `Start on ${project.name}` : hasAccount ? 'Sign in to start' : 'Create an account to start'}
      />
      <Form
        className=""
        initialValues={{ name: '', password: '' }}
        mutation={accept}
        onSubmit={({ name, password }) =>
          accept.mutate(
            { name: hasAccount || isThem ? null : name, password: isThem ? null : password },
            {
              onSuccess: ({ project_id: projectId }) =>
                void router.navigate({ to: '/projects/$projectId/desk', params: { projectId } }),
            },
          )
        }
      >
        <p className="mid">
          {isThem
            ? `You are signed in as ${visitor.person.name}.`
            : hasAccount
              ? `${email} already has an account.`
              : `For ${email}. You need an account to deliver and to get answers.`}
        </p>
        {!hasAccount && !isThem && <Field name="name" label="Your name" autoComplete="name" ref={firstField} />}
        {!isThem && (
          <>
            <input type="hidden" name="username" autoComplete="username" value={email} />
            <Field
              name="password"
              type="password"
              label={hasAccount ? 'Password' : 'New password'}
              description={hasAccount ? undefined : 'At least 10 characters.'}
              autoComplete={hasAccount ? 'current-password' : 'new-password'}
              ref={hasAccount ? firstField : undefined}
            />
          </>
        )}
        <Submit
          className={`flex wrap gap-2 ${classes.actions}`}
          beside={
            <Button variant="quiet" onClick={onBack}>
              View the sound list first
            </Button>
          }
        >
          {isThem
            ? 'Go to your desk'
            : hasAccount
              ? 'Sign in and go to your desk'
              : 'Create account and go to your desk'}
        </Submit>
      </Form>
    </Card>
  )
}
