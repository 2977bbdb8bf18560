import { useEffect, useRef, useState } from 'react'

import { Button, type ButtonProps } from './Button'
import classes from './CopyButton.module.css'
import { copyText } from './copyText'
import { isMac } from './keyNames'

const SAID_FOR_MS = 5_000

interface CopyButtonProps extends Omit<ButtonProps, 'onClick' | 'icon'> {
  /** What is copied, or how to make it at the press. */
  text: string | (() => string)
  /** What it is: "Link" is said as "Link copied.". */
  what: string
}

type State = { kind: 'idle' } | { kind: 'copied' } | { kind: 'refused'; text: string }

/** Copies a text, and says so; where the browser lets no page copy, the text stands selected for the keys. */
export function CopyButton({ text, what, className, ...button }: CopyButtonProps) {
  const [state, setState] = useState<State>({ kind: 'idle' })
  const field = useRef<HTMLTextAreaElement>(null)
  useEffect(() => {
    if (state.kind === 'refused') field.current?.focus() // which selects it
    if (state.kind !== 'copied') return
    const timer = setTimeout(() => setState({ kind: 'idle' }), SAID_FOR_MS)
    return () => clearTimeout(timer)
  }, [state])
  const copied = () => setState({ kind: 'copied' })
  const copy = async (near: HTMLElement) => {
    const value = typeof text === 'function' ? text() : text
    if (await copyText(value, near)) copied()
    else setState({ kind: 'refused', text: value })
  }
  return (
    <span className={`inline-flex wrap items-center ${classes.copy} ${className ?? ''}`}>
      <Button
        {...button}
        icon={state.kind === 'copied' ? 'tick' : 'copy'}
        onClick={({ currentTarget }) => void copy(currentTarget)}
      />
      <span role="status" className={`small ${classes.said}`}>
        {state.kind === 'copied' && `${what} copied.`}
        {state.kind === 'refused' && `This browser does not let the page copy. Press ${isMac() ? '⌘C' : 'Ctrl+C'}.`}
      </span>
      {state.kind === 'refused' && (
        <textarea
          ref={field}
          className={`bg-raised min-w-0 w-full font-mono text-small border rounded ${classes.field}`}
          readOnly
          rows={Math.min(4, state.text.split('\n').length)}
          aria-label="Text to copy"
          value={state.text}
          onFocus={({ currentTarget }) => currentTarget.select()}
          onCopy={() => setTimeout(copied)} // the browser reads the selection after this event
          onKeyDown={(event) => {
            if (event.key !== 'Escape') return
            event.stopPropagation()
            setState({ kind: 'idle' })
          }}
        />
      )}
    </span>
  )
}
