import { type ReactNode, useEffect, useRef, useState } from 'react'

import { Button, type ButtonProps } from './Button'

interface ConfirmInlineProps extends Pick<ButtonProps, 'variant' | 'icon' | 'disabled' | 'aria-label' | 'aria-busy'> {
  /** The button that asks. */
  children: string
  /** The button that does it, named after what it does: "Terminate contract". */
  action: string
  /** The button that keeps things as they are: "Keep contract". */
  keep?: string
  /** What follows, and who is told. */
  consequence?: ReactNode
  /** What it is done to, read out with the buttons where a page has several. */
  about?: string
  onConfirm: () => void
}

/** Asks in place before an act that cannot be undone. What can be undone is done at once, with Undo in the toast. */
export function ConfirmInline({
  children,
  action,
  keep = 'Cancel',
  consequence,
  about,
  onConfirm,
  ...button
}: ConfirmInlineProps) {
  const [isAsked, setAsked] = useState(false)
  const back = useRef<HTMLButtonElement>(null)
  const ask = useRef<HTMLButtonElement>(null)
  const wasAsked = useRef(false)
  useEffect(() => {
    if (isAsked)
      back.current?.focus() // the button that was pressed has gone
    else if (wasAsked.current) ask.current?.focus()
    wasAsked.current = isAsked
  }, [isAsked])
  if (!isAsked) {
    return (
      <Button {...button} ref={ask} onClick={() => setAsked(true)}>
        {children}
      </Button>
    )
  }
  return (
    // Escape goes back from either of its buttons; there is nothing to press on the group itself.
    // eslint-disable-next-line jsx-a11y/no-noninteractive-element-interactions
    <span
      role="group"
      aria-label={about === undefined ? action : `${action}: ${about}`}
      onKeyDown={(event) => {
        if (event.key !== 'Escape') return
        event.stopPropagation()
        setAsked(false)
      }}
    >
      {consequence !== undefined && <span className="small mid">{consequence} </span>}
      <span className="row wrap">
        <Button variant="danger" aria-busy={button['aria-busy']} onClick={onConfirm}>
          {action}
        </Button>
        <Button variant="quiet" ref={back} onClick={() => setAsked(false)}>
          {keep}
        </Button>
      </span>
    </span>
  )
}
