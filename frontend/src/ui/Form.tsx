import { PasswordInput, TextInput } from '@mantine/core'
import {
  type ComponentProps,
  type ComponentPropsWithRef,
  createContext,
  type ElementType,
  type FormEvent,
  type ReactNode,
  useContext,
  useEffect,
  useEffectEvent,
  useRef,
  useState,
} from 'react'

import { ApiProblem } from '@/api/problem'

import { Button, type ButtonProps } from './Button'
import { emptyFields } from './emptyFields'
import classes from './Form.module.css'
import { Refusal } from './Refusal'
import { sentence } from './sentence'

type Values = Record<string, unknown>
type Errors = Record<string, string>

interface FormState {
  values: Values
  errors: Errors
  change: (part: Values) => void
  isPending: boolean
}

const State = createContext<FormState | null>(null)

/** Return the form round a field or a button. */
function useFormState(): FormState {
  const state = useContext(State)
  if (state === null) throw new Error('A Field or a Submit stands outside of a Form.')
  return state
}

type Checks<V> = { [name in keyof V]?: string | false | null }

export interface FormProps<V> extends Omit<ComponentPropsWithRef<'form'>, 'onSubmit' | 'onReset' | 'children'> {
  /** The values of all fields as the form opens. */
  initialValues: V
  /** The mutation that sends the form: while it waits nothing is sent again, and its refusal is shown. */
  mutation: { isPending: boolean; isSuccess?: boolean; error: unknown }
  /** What does not fit, by field, looked at as the form is sent: such a form is not sent. */
  checks?: (values: V) => Checks<V>
  onSubmit: (values: V) => void
  /** Who keeps the values; without it the form does. */
  values?: V
  onValuesChange?: (values: V) => void
  /** Empties the form once it is sent, but for what it returns. Without it what was typed stays. */
  resets?: boolean | ((values: V) => Partial<V>)
  children: ReactNode | ((values: V, change: (part: Partial<V>) => void) => ReactNode)
}

const errorsOf = (error: unknown) => (error instanceof ApiProblem ? error.errors : [])

/** Fields and a button that sends them. What the server refuses stands below its field, and what was typed stays. */
export function Form<V extends object>({
  initialValues,
  mutation: { isPending, isSuccess, error },
  checks,
  onSubmit,
  values: kept,
  onValuesChange,
  resets = false,
  className = classes.form,
  children,
  ...rest
}: FormProps<V>) {
  const [typed, setTyped] = useState(initialValues)
  const [errors, setErrors] = useState<Errors>({})
  const form = useRef<HTMLFormElement>(null)
  const values = kept ?? typed
  const refused = errorsOf(error)
  const isSaidBelowFields = refused.length > 0 && refused.every(({ field }) => field in initialValues)

  const change = (part: Partial<V>) => {
    const next = { ...values, ...part }
    setTyped(next)
    onValuesChange?.(next)
    setErrors((before) => Object.fromEntries(Object.entries(before).filter(([name]) => !(name in part))))
  }
  const show = (found: Errors) => {
    setErrors(found)
    const [first] = Object.keys(found)
    if (first) form.current?.querySelector<HTMLElement>(`[data-path="${first}"]`)?.focus()
  }
  const showRefusal = useEffectEvent(() =>
    show(Object.fromEntries(refused.map(({ field, message }) => [field, sentence(message)]))),
  )
  useEffect(() => {
    if (error instanceof ApiProblem) showRefusal()
  }, [error])
  const clear = useEffectEvent(() =>
    setTyped({ ...initialValues, ...(typeof resets === 'function' && resets(values)) }),
  )
  useEffect(() => {
    if (resets && isSuccess) clear()
  }, [resets, isSuccess])

  const send = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault()
    if (isPending) return
    const unfit = Object.entries(checks?.(values) ?? {}).filter((entry): entry is [string, string] => Boolean(entry[1]))
    const found = { ...emptyFields(event.currentTarget), ...Object.fromEntries(unfit) }
    show(found)
    if (Object.keys(found).length === 0) onSubmit(values)
  }
  return (
    <State value={{ values: values as Values, errors, change: change as FormState['change'], isPending }}>
      <form ref={form} {...rest} className={className} onSubmit={send} noValidate>
        {typeof children === 'function' ? children(values, change) : children}
        {!isSaidBelowFields && <Refusal error={error} className="col-span-full" />}
      </form>
    </State>
  )
}

type FieldProps<C extends ElementType> = Omit<
  ComponentProps<C>,
  'name' | 'value' | 'checked' | 'error' | 'required' | 'onChange'
> & {
  name: string
  /** What it is typed into, where it is not one line: Textarea, NativeSelect, NumberInput, Checkbox. */
  as?: C
  type?: string
  /** May stay empty. */
  optional?: boolean
  /** Called with what is typed. */
  onValue?: (value: string) => void
}

const valueOf = (given: unknown): unknown => {
  if (typeof given !== 'object' || given === null || !('currentTarget' in given)) return given
  const { type, checked, value } = given.currentTarget as HTMLInputElement
  return type === 'checkbox' ? checked : value
}

/** One input of a form, with its error below. */
export function Field<C extends ElementType = typeof TextInput>({
  name,
  as,
  optional = false,
  onValue,
  ...rest
}: FieldProps<C>) {
  const { values, errors, change } = useFormState()
  const value = values[name]
  const { type } = rest as { type?: string }
  const Input: ElementType = as ?? (type === 'password' ? PasswordInput : TextInput)
  const bound = {
    ...(type === 'email' && { inputMode: 'email', spellCheck: false }),
    ...(type === 'password' && { type: undefined, visibilityToggleButtonProps: { 'aria-label': 'Show password' } }),
    ...(typeof value === 'boolean' ? { checked: value } : { value, required: !optional, withAsterisk: false }),
  }
  return (
    <Input
      {...rest}
      {...bound}
      name={name}
      data-path={name}
      error={errors[name]}
      onChange={(given: unknown) => {
        const next = valueOf(given)
        change({ [name]: next })
        onValue?.(next as string)
      }}
    />
  )
}

interface SubmitProps extends Pick<ButtonProps, 'keys' | 'disabled' | 'icon' | 'variant' | 'aria-label'> {
  /** A verb: "Sign in". */
  children: ReactNode
  /** Beside the button: an alternative. */
  beside?: ReactNode
  /** Closes the form. */
  onCancel?: () => void
  /** Of the line of buttons. */
  className?: string
}

/** The button that sends the form. It shows that it waits. */
export function Submit({ children, beside, onCancel, className, variant = 'primary', ...rest }: SubmitProps) {
  const { isPending } = useFormState()
  return (
    <div className={className ?? (beside ? 'flex wrap items-center between gap-2-4' : 'row wrap')}>
      <Button type="submit" variant={variant} aria-busy={isPending} {...rest}>
        {children}
      </Button>
      {onCancel && (
        <Button variant="quiet" onClick={onCancel}>
          Cancel
        </Button>
      )}
      {beside}
    </div>
  )
}
