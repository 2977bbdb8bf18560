import { PasswordInput, TextInput } from '@mantine/core'
import { type ChangeEvent, createContext, type FormEvent, type ReactNode, useContext, useState } from 'react'

import { ApiProblem } from '@/api'
import { keepDraft, keptDraft } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Card } from '@/ui/Card'
import { emptyFields } from '@/ui/emptyFields'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Form.module.css'

/** What stands against a field of the form, by its name. */
const Against = createContext<(name: string) => string | undefined>(() => undefined)
/** What was typed before, by the name of the field. */
const Typed = createContext<Readonly<Record<string, string>>>({})

/** What stands against the fields of a form; anything else that broke is not a refusal of what was typed. */
export const refusalOf = (error: unknown): ApiProblem | null => (error instanceof ApiProblem ? error : null)

/** Sentences of the server begin small where they follow a name. */
export const sentence = (text: string): string => {
  const begun = text.charAt(0).toUpperCase() + text.slice(1)
  return /[.?!]$/.test(begun) ? begun : `${begun}.`
}

interface FieldProps {
  name: string
  label: string
  type?: 'text' | 'email' | 'password'
  autoComplete?: string
  hint?: string
  defaultValue?: string
  readOnly?: boolean
  /** Called with what is typed. */
  onValue?: (value: string) => void
}

/** One line to fill in, with what the server says of it below. */
export function Field({ name, label, type = 'text', hint, onValue, ...rest }: FieldProps) {
  const message = useContext(Against)(name)
  const typed = useContext(Typed)[name]
  const given = {
    ...rest,
    ...(typed === undefined ? {} : { defaultValue: typed }),
    name,
    label,
    description: hint,
    required: true,
    ...(onValue && { onChange: ({ currentTarget }: ChangeEvent<HTMLInputElement>) => onValue(currentTarget.value) }),
    withAsterisk: false,
    error: message && sentence(message),
  }
  if (type === 'password') {
    return <PasswordInput {...given} visibilityToggleButtonProps={{ 'aria-label': 'Show password' }} />
  }
  return <TextInput {...given} type={type} inputMode={type === 'email' ? 'email' : undefined} spellCheck={false} />
}

interface FormProps {
  /** Keeps what is typed under this name until it is sent; passwords are never kept. */
  draftKey?: string
  /** A verb: "Sign in". */
  action: string
  busy: boolean
  error: unknown
  onSubmit: (values: (name: string) => string) => void
  children: ReactNode
  /** Next to the button: an alternative. */
  other?: ReactNode
}

/** The values of a form's text fields, without passwords. */
const textsOf = (form: HTMLFormElement): Record<string, string> =>
  Object.fromEntries(
    [...form.querySelectorAll<HTMLInputElement>('input[name]')]
      .filter(({ type, autocomplete }) => (type === 'text' || type === 'email') && !autocomplete.includes('password'))
      .map(({ name, value }) => [name, value]),
  )

/** Fields and one button. Nothing typed is lost when it is refused. */
export function Form({ draftKey, action, busy, error, onSubmit, children, other }: FormProps) {
  const refusal = refusalOf(error)
  const [typed] = useState(() => (draftKey === undefined ? {} : (keptDraft<Record<string, string>>(draftKey) ?? {})))
  const [missing, setMissing] = useState<Record<string, string>>({})
  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    if (busy) return
    const empty = emptyFields(event.currentTarget)
    setMissing(empty)
    if (Object.keys(empty).length > 0) return
    const data = new FormData(event.currentTarget)
    onSubmit((name) => {
      const value = data.get(name)
      return typeof value === 'string' ? value : ''
    })
  }
  return (
    <Against value={(name) => missing[name] ?? refusal?.of(name)?.message}>
      <form
        className={classes.form}
        onSubmit={send}
        onInput={(event) => {
          if (draftKey !== undefined) keepDraft(draftKey, textsOf(event.currentTarget))
        }}
        noValidate
      >
        <Typed value={typed}>{children}</Typed>
        {error !== null && error !== undefined && (refusal === null || refusal.errors.length === 0) && (
          <ProblemNote
            detail={sentence(refusal?.detail ?? 'The form could not be sent. Something went wrong in the page.')}
            fix={refusal?.fix ? sentence(refusal.fix) : undefined}
          />
        )}
        <div className={classes.foot}>
          <Button type="submit" variant="primary" className={classes.go} aria-busy={busy}>
            {action}
          </Button>
          {other}
        </div>
      </form>
    </Against>
  )
}

/** The one card of a page before an account. */
export function Sheet({ children, wide = false }: { children: ReactNode; wide?: boolean }) {
  return (
    <div className="page">
      <Card className={wide ? `${classes.sheet} ${classes.wide}` : classes.sheet}>{children}</Card>
    </div>
  )
}
