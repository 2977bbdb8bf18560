import { PasswordInput, TextInput } from '@mantine/core'
import { useForm, type UseFormReturnType } from '@mantine/form'
import {
  type ChangeEvent,
  type ComponentPropsWithRef,
  createContext,
  type FormEvent,
  type ReactNode,
  useContext,
  useEffect,
  useEffectEvent,
} from 'react'

import { ApiProblem } from '@/api/problem'

import { Button, type ButtonProps } from './Button'
import { emptyFields } from './emptyFields'
import classes from './Form.module.css'
import { Refusal } from './Refusal'
import { sentence } from './sentence'

type Values = Record<string, unknown>

interface FormState {
  form: UseFormReturnType<Values>
  isPending: boolean
}

const State = createContext<FormState | null>(null)

/** Return the form round a field or a button. */
function useFormState(): FormState {
  const state = useContext(State)
  if (state === null) throw new Error('A Field or a Submit stands outside of a Form.')
  return state
}

interface FormProps<V> extends Omit<ComponentPropsWithRef<'form'>, 'onSubmit' | 'onReset'> {
  /** The values of all fields as the form opens. */
  initialValues: V
  /** The mutation that sends the form: while it waits nothing is sent again, and its refusal is shown. */
  mutation: { isPending: boolean; isSuccess?: boolean; error: unknown }
  onSubmit: (values: V) => void
  onValuesChange?: (values: V) => void
  /** Empties the form once it is sent. Without it what was typed stays. */
  resets?: boolean
}

/** Fields and a button that sends them. What the server refuses stands below its field, and what was typed stays. */
export function Form<V extends Values>({
  initialValues,
  mutation: { isPending, isSuccess, error },
  onSubmit,
  onValuesChange,
  resets = false,
  className,
  children,
  ...rest
}: FormProps<V>) {
  const form = useForm<Values>({
    mode: 'uncontrolled',
    initialValues,
    onValuesChange: (values) => onValuesChange?.(values as V),
  })
  const { setErrors, getInputNode, reset } = form
  const errors = error instanceof ApiProblem ? error.errors : []
  const isSaidBelowFields = errors.length > 0 && errors.every(({ field }) => field in initialValues)

  const showRefusal = useEffectEvent((refusal: ApiProblem) => {
    const [first] = refusal.errors
    setErrors(Object.fromEntries(refusal.errors.map(({ field, message }) => [field, sentence(message)])))
    if (first) getInputNode(first.field)?.focus()
  })
  useEffect(() => {
    if (error instanceof ApiProblem) showRefusal(error)
  }, [error])
  const clear = useEffectEvent(() => reset())
  useEffect(() => {
    if (resets && isSuccess) clear()
  }, [resets, isSuccess])

  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    if (isPending) return
    const empty = emptyFields(event.currentTarget)
    setErrors(empty)
    if (Object.keys(empty).length === 0) onSubmit(form.getValues() as V)
  }
  return (
    <State value={{ form, isPending }}>
      <form {...rest} className={[classes.form, className].filter(Boolean).join(' ')} onSubmit={send} noValidate>
        {children}
        {!isSaidBelowFields && <Refusal error={error} />}
      </form>
    </State>
  )
}

/** Return what binds any input of Mantine to a field of the form, with its error. */
export function useField(name: string, type: 'input' | 'checkbox' = 'input') {
  const { form } = useFormState()
  return { fieldKey: form.key(name), props: { name, ...form.getInputProps(name, { type }) } as Values }
}

interface FieldProps {
  name: string
  label: string
  type?: 'text' | 'email' | 'password'
  autoComplete?: string
  hint?: ReactNode
  readOnly?: boolean
  maxLength?: number
  /** Called with what is typed. */
  onValue?: (value: string) => void
}

/** One line that must be filled in, with its error below. */
export function Field({ name, type = 'text', hint, onValue, ...rest }: FieldProps) {
  const { fieldKey, props } = useField(name)
  const onChange = props.onChange as (event: ChangeEvent<HTMLInputElement>) => void
  const given = {
    ...rest,
    ...props,
    description: hint,
    required: true,
    withAsterisk: false,
    onChange: (event: ChangeEvent<HTMLInputElement>) => {
      onChange(event)
      onValue?.(event.currentTarget.value)
    },
  }
  if (type === 'password') {
    return <PasswordInput key={fieldKey} {...given} visibilityToggleButtonProps={{ 'aria-label': 'Show password' }} />
  }
  const mode = type === 'email' ? 'email' : undefined
  return <TextInput key={fieldKey} {...given} type={type} inputMode={mode} spellCheck={false} />
}

interface SubmitProps extends Pick<ButtonProps, 'keys' | 'disabled'> {
  /** A verb: "Sign in". */
  children: ReactNode
  /** Beside the button: an alternative. */
  beside?: ReactNode
}

/** The button that sends the form. It shows that it waits. */
export function Submit({ children, beside, ...rest }: SubmitProps) {
  const { isPending } = useFormState()
  return (
    <div className="flex wrap items-center between gap-2-4">
      <Button type="submit" variant="primary" className={classes.go} aria-busy={isPending} {...rest}>
        {children}
      </Button>
      {beside}
    </div>
  )
}
