import { useEffect, useRef, useState } from 'react'

import { ApiProblem } from '@/api'
import { Field } from '@/ui/Form'

/** Whether the server has asked for a second factor; once it has, the field stays. */
export function useSecondFactorAsked(error: unknown): boolean {
  const [isAsked, setAsked] = useState(false)
  if (!isAsked && error instanceof ApiProblem && error.code === 'second-factor-needed') setAsked(true)
  return isAsked
}

/** The second factor of a sign-in; it takes the focus when it is asked for. */
export function CodeField() {
  const field = useRef<HTMLDivElement>(null)
  useEffect(() => field.current?.querySelector('input')?.focus(), [])
  return (
    <div ref={field}>
      <Field
        name="code"
        label="Code"
        autoComplete="one-time-code"
        description="From your authenticator app, or one of your recovery codes."
      />
    </div>
  )
}
