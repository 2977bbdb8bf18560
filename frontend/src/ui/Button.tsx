import { type ComponentPropsWithRef, createElement, type ReactNode } from 'react'

import classes from './Button.module.css'
import { Icon, type IconName } from './Icon'
import { Key } from './Key'
import { ariaKeys } from './keyNames'
import { usePending } from './usePending'

interface Look {
  /** primary: ink-filled, one a region. quiet: no border. danger: does what cannot be undone. */
  variant?: 'plain' | 'primary' | 'quiet' | 'danger'
  icon?: IconName
  /** The tone of the icon alone: colour is a verdict, and a button is none. */
  iconTone?: 'ok' | 'bad' | 'warn' | 'change' | 'review'
  /** The key that does the same, drawn as a cap. */
  keys?: string
  /** Square, with the icon alone; then `aria-label` says what it does. */
  square?: boolean
  /** 44 px high with a heavier foot, as in the verdict bar. */
  tall?: boolean
}

export interface ButtonProps extends Omit<ComponentPropsWithRef<'button'>, 'children'>, Look {
  children?: ReactNode
  /** Pressed or not, for a button that stays down. */
  pressed?: boolean
}

function classOf({ variant = 'plain', square, tall }: Look, extra?: string): string {
  return [
    classes.button,
    classes[variant],
    square ? classes.square : '',
    tall ? classes.tall : '',
    variant === 'primary' ? 'on-ink' : '',
    extra ?? '',
  ]
    .filter(Boolean)
    .join(' ')
}

function Inside({ icon, iconTone, keys, children }: Look & { children?: ReactNode }) {
  return (
    <>
      {icon && (
        <span className={iconTone ? `${classes.icon} ${classes.tonedIcon} tone-${iconTone}` : classes.icon}>
          <Icon name={icon} />
        </span>
      )}
      {children}
      {keys && <Key keys={keys} />}
    </>
  )
}

/**
 * A button: a verb, its sign before it, its key after it. While what it began waits for an answer it is pressed once, and
 * shows that it waits; `aria-busy` says the same of a wait that began elsewhere.
 */
export function Button({
  variant,
  icon,
  iconTone,
  keys,
  square,
  tall,
  pressed,
  children,
  className,
  onClick,
  'aria-busy': busy,
  ...rest
}: ButtonProps) {
  const [isPending, run] = usePending()
  const isBusy = isPending || busy === true || busy === 'true'
  return (
    <button
      type="button"
      {...rest}
      aria-busy={isBusy || undefined}
      onClick={(event) => {
        if (isBusy) event.preventDefault()
        else run(() => onClick?.(event))
      }}
      className={classOf({ variant, square, tall }, className)}
      aria-pressed={pressed}
      aria-keyshortcuts={keys && ariaKeys(keys)}
    >
      <Inside icon={icon} iconTone={iconTone} keys={keys}>
        {children}
      </Inside>
    </button>
  )
}

/** The look of a button for something that leads elsewhere: pass the router's Link as `component`, or an `href`. */
export function ButtonLink<P extends object = ComponentPropsWithRef<'a'>>({
  component = 'a',
  variant,
  icon,
  iconTone,
  keys,
  square,
  tall,
  children,
  ...rest
}: Look & { component?: React.ElementType<P> | 'a'; children?: ReactNode; className?: string } & P) {
  return createElement(
    component as React.ElementType,
    {
      ...rest,
      className: classOf({ variant, square, tall }, rest.className),
      'aria-keyshortcuts': keys && ariaKeys(keys),
    },
    <Inside icon={icon} iconTone={iconTone} keys={keys}>
      {children}
    </Inside>,
  )
}
