import type { ReactNode } from 'react'

import { Icon } from './Icon'
import classes from './ErrorBanner.module.css'

interface ErrorBannerProps {
  /** What was refused or what broke, in a sentence. */
  detail: string
  /** What to do about it. */
  fix?: string
  action?: ReactNode
  className?: string
}

const ACCOUNT = /(page Account)/

/** What to do, with a link where it names the page that shows one's account. */
const linked = (fix: string) =>
  fix.split(ACCOUNT).map((part) =>
    ACCOUNT.test(part) ? (
      <a key={part} className="link" href="/account">
        {part}
      </a>
    ) : (
      part
    ),
  )

/** A refusal, said where it happened and until it is put right. */
export function ErrorBanner({ detail, fix, action, className }: ErrorBannerProps) {
  return (
    <div role="alert" className={`flex items-start gap-2 ${classes.note} tone-bad ${className ?? ''}`}>
      <Icon name="back" />
      <p>
        <span className="toned">{detail}</span> {fix !== undefined && linked(fix)}
      </p>
      {action}
    </div>
  )
}
