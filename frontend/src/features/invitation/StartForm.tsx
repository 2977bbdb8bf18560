import { PasswordInput, TextInput } from '@mantine/core'
import { useRouter } from '@tanstack/react-router'
import { type FormEvent, useState } from 'react'

import { ApiProblem } from '@/api'
import type { components } from '@/api/schema.gen'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { emptyFields } from '@/ui/emptyFields'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Invitation, useAccept } from './api'
import classes from './Invitation.module.css'

interface StartFormProps {
  secret: string
  invitation: Invitation
  visitor: components['schemas']['Me'] | null
  onBack: () => void
}

const capitalised = (text: string) => text.charAt(0).toUpperCase() + text.slice(1)

/** The account, asked for only now: so that files, verdicts and money have an owner. */
export function StartForm({ secret, invitation, visitor, onBack }: StartFormProps) {
  const router = useRouter()
  const accept = useAccept(secret)
  const { email, has_account: hasAccount, project } = invitation
  const isThem = visitor?.email === email
  const nameField = useFocusOnMount<HTMLInputElement>(!hasAccount)
  const passwordField = useFocusOnMount<HTMLInputElement>(hasAccount)
  const [missing, setMissing] = useState<Record<string, string>>({})
  const refusal = accept.error instanceof ApiProblem ? accept.error : null
  const against = (field: string) => {
    const message = missing[field] ?? refusal?.of(field)?.message
    return message && capitalised(message)
  }
  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    if (accept.isPending) return
    const empty = emptyFields(event.currentTarget)
    setMissing(empty)
    if (Object.keys(empty).length > 0) return
    const data = new FormData(event.currentTarget)
    const typed = (name: string) => {
      const value = data.get(name)
      return typeof value === 'string' ? value : ''
    }
    accept.mutate(
      { name: hasAccount || isThem ? null : typed('name'), password: isThem ? null : typed('password') },
      {
        onSuccess: ({ project_id: projectId }) =>
          void router.navigate({ to: '/projects/$projectId/desk', params: { projectId } }),
      },
    )
  }
  return (
    <Card aria-labelledby="start" className={classes.form}>
      <CardHead
        id="start"
        title={isThem ? `Start on ${project.name}` : hasAccount ? 'Sign in to start' : 'Create an account to start'}
      />
      <form onSubmit={send} noValidate>
        <p className="mid">
          {isThem
            ? `You are signed in as ${visitor.person.name}.`
            : hasAccount
              ? `${email} already has an account.`
              : `For ${email}. You need an account to deliver and to get answers.`}
        </p>
        {!hasAccount && !isThem && (
          <TextInput
            name="name"
            label="Your name"
            autoComplete="name"
            required
            withAsterisk={false}
            ref={nameField}
            error={against('name')}
          />
        )}
        {!isThem && (
          <>
            <input type="hidden" name="username" autoComplete="username" value={email} />
            <PasswordInput
              name="password"
              label={hasAccount ? 'Password' : 'New password'}
              description={hasAccount ? undefined : 'At least 10 characters.'}
              autoComplete={hasAccount ? 'current-password' : 'new-password'}
              required
              withAsterisk={false}
              ref={passwordField}
              error={against('password')}
              visibilityToggleButtonProps={{ 'aria-label': 'Show password' }}
            />
          </>
        )}
        {refusal && refusal.errors.length === 0 && (
          <ErrorBanner detail={capitalised(refusal.detail)} fix={refusal.fix && capitalised(refusal.fix)} />
        )}
        <div className={`flex wrap gap-2 ${classes.actions}`}>
          <Button type="submit" variant="primary" aria-busy={accept.isPending}>
            {isThem
              ? 'Go to your desk'
              : hasAccount
                ? 'Sign in and go to your desk'
                : 'Create account and go to your desk'}
          </Button>
          <Button variant="quiet" onClick={onBack}>
            View the sound list first
          </Button>
        </div>
      </form>
    </Card>
  )
}
