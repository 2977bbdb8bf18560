import type { ComponentPropsWithRef, KeyboardEvent } from 'react'

interface ChoiceProps extends Omit<ComponentPropsWithRef<'div'>, 'onClick' | 'role'> {
  checked: boolean
  onChoose: () => void
}

const STEPS: Readonly<Record<string, number>> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }

/** The arrows choose the next one of the group, as in every group of radio buttons; Space and Enter stay the page's. */
function step(event: KeyboardEvent<HTMLElement>): void {
  const by = STEPS[event.key]
  const group = event.currentTarget.closest('[role="radiogroup"]')
  if (by === undefined || group === null) return
  event.preventDefault()
  const choices = [...group.querySelectorAll<HTMLElement>('[role="radio"]')]
  const to = choices[(choices.indexOf(event.currentTarget) + by + choices.length) % choices.length]
  to?.focus()
  to?.click()
}

/** One of several things of which one is in the hand; the group round it has the role `radiogroup`. */
export function Choice({ checked, onChoose, children, ...rest }: ChoiceProps) {
  return (
    // The arrows are its keys; Enter and Space choose nothing that the arrows have not chosen.
    <div {...rest} role="radio" aria-checked={checked} tabIndex={checked ? 0 : -1} onClick={onChoose} onKeyDown={step}>
      {children}
    </div>
  )
}
