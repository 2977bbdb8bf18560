import { PasswordInput, TextInput } from '@mantine/core'
import { useForm, type UseFormReturnType } from '@mantine/form'
import {
  type ComponentProps,
  type ComponentPropsWithRef,
  createContext,
  type ElementType,
  type ReactNode,
  useContext,
  useEffect,
  useEffectEvent,
  useLayoutEffect,
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
const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b)

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
  const element = useRef<HTMLFormElement>(null)
  const form = useForm<Values>({
    initialValues: (kept ?? initialValues) as Values,
    validate: (values) => ({ ...emptyFields(element.current), ...checks?.(values as V) }),
    onValuesChange: (values) => onValuesChange?.(values as V),
  })
  const values = form.values as V
  const [isSaidBelowFields, setSaidBelowFields] = useState(false)

  const field = (name: string) => element.current?.querySelector<HTMLElement>(`[data-path="${CSS.escape(name)}"]`)
  const focus = (errors: object) => field(Object.keys(errors)[0] ?? '')?.focus()
  const showRefusal = useEffectEvent(() => {
    const refused = errorsOf(error)
    const errors = Object.fromEntries(refused.map(({ field: name, message }) => [name, sentence(message)]))
    setSaidBelowFields(refused.length > 0 && refused.every(({ field: name }) => field(name)))
    if (error instanceof ApiProblem) form.setErrors(errors)
    focus(errors)
  })
  useLayoutEffect(() => showRefusal(), [error])
  const follow = useEffectEvent(() => {
    if (kept && !same(kept, form.getValues())) form.setValues(kept)
  })
  useEffect(() => follow(), [kept])
  const clear = useEffectEvent(() =>
    form.setValues({ ...initialValues, ...(typeof resets === 'function' && resets(values)) }),
  )
  useEffect(() => {
    if (resets && isSuccess) clear()
  }, [resets, isSuccess])

  const send = form.onSubmit((typed) => onSubmit(typed as V), focus)
  const change = (part: Partial<V>) => Object.entries(part).forEach(([name, value]) => form.setFieldValue(name, value))
  return (
    <State value={{ form, isPending }}>
      <form
        ref={element}
        {...rest}
        className={className}
        onSubmit={(event) => (isPending ? event.preventDefault() : send(event))}
        noValidate
      >
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

type Bound = Values & { onChange: (given: unknown) => void }

/** One input of a form, with its error below. */
export function Field<C extends ElementType = typeof TextInput>({
  name,
  as,
  optional = false,
  onValue,
  ...rest
}: FieldProps<C>) {
  const { form } = useFormState()
  const isChecked = typeof form.values[name] === 'boolean'
  const { type } = rest as { type?: string }
  const Input: ElementType = as ?? (type === 'password' ? PasswordInput : TextInput)
  const bound = form.getInputProps(name, { type: isChecked ? 'checkbox' : 'input', withFocus: false }) as Bound
  return (
    <Input
      {...rest}
      {...bound}
      {...(type === 'email' && { inputMode: 'email', spellCheck: false })}
      {...(type === 'password' && { type: undefined, visibilityToggleButtonProps: { 'aria-label': 'Show password' } })}
      {...(!isChecked && { required: !optional, withAsterisk: false })}
      name={name}
      onChange={(given: unknown) => {
        bound.onChange(given)
        onValue?.(form.getValues()[name] as string)
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
