import type { ComponentPropsWithRef } from 'react'

interface SendFieldProps extends ComponentPropsWithRef<'textarea'> {
  value: string
  onText: (text: string) => void
  onSend: () => void
  /** Escape: what opened the field closes it. */
  onLeave: () => void
}

const MOST_ROWS = 8

/** A text that Enter sends; Shift and Enter begin a new line. It grows with what is typed. */
export function SendField({ value, onText, onSend, onLeave, onKeyDown, rows = 1, ...rest }: SendFieldProps) {
  return (
    <textarea
      maxLength={10_000}
      {...rest}
      rows={Math.min(MOST_ROWS, Math.max(rows, value.split('\n').length))}
      value={value}
      onChange={(event) => onText(event.currentTarget.value)}
      onKeyDown={(event) => {
        onKeyDown?.(event)
        if (event.defaultPrevented) return
        if (event.key === 'Enter' && !event.shiftKey && !event.nativeEvent.isComposing) {
          event.preventDefault()
          onSend()
        } else if (event.key === 'Escape') {
          event.stopPropagation()
          onLeave()
        }
      }}
    />
  )
}
