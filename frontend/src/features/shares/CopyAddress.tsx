import { useRef } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'

import classes from './Shares.module.css'

/** An address to send to guests. */
export function CopyAddress({ url, title }: { url: string; title: string }) {
  const field = useRef<HTMLInputElement>(null)
  const copy = async () => {
    try {
      await navigator.clipboard.writeText(url)
      showToast('Link copied.')
    } catch {
      field.current?.select() // the browser keeps the clipboard closed: one presses Ctrl C
    }
  }
  return (
    <div className={classes.address}>
      <input
        ref={field}
        className={classes.url}
        readOnly
        value={url}
        aria-label={`Address of ${title}`}
        onFocus={(event) => event.currentTarget.select()}
      />
      <Button icon="copy" onClick={() => void copy()}>
        Copy
      </Button>
    </div>
  )
}
