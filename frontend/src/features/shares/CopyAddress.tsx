import { CopyButton } from '@/ui/CopyButton'

import classes from './Shares.module.css'

/** An address to send to guests. */
export function CopyAddress({ url, title }: { url: string; title: string }) {
  return (
    <div className="flex gap-2">
      <input
        className={`flex-1 min-w-0 bg-raised rounded ${classes.url}`}
        readOnly
        value={url}
        aria-label={`Address of ${title}`}
        onFocus={(event) => event.currentTarget.select()}
      />
      <CopyButton text={url} what="Link">
        Copy
      </CopyButton>
    </div>
  )
}
