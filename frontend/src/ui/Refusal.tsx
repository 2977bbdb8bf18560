import type { ReactNode } from 'react'

import { ApiProblem } from '@/api/problem'

import { ErrorBanner } from './ErrorBanner'
import { sentence } from './sentence'

interface RefusalProps {
  /** The error of a query or a mutation; nothing is drawn while there is none. */
  error?: unknown
  /** What was to be done, where the sentence alone would not say: a file's name, or a sentence. */
  about?: string
  action?: ReactNode
  /** What to do, where the server does not say it. */
  fix?: string
  /** Stands in a card by itself, away from its edges. */
  inset?: boolean
  className?: string
}

/** What the server refused and what to do about it, said where it was asked. */
export function Refusal({ error, about, action, fix, inset = false, className }: RefusalProps) {
  if (error === null || error === undefined) return null
  const problem = error instanceof ApiProblem ? error : null
  const detail = problem ? sentence(problem.detail) : 'Something went wrong in the page. What you typed is kept.'
  return (
    <ErrorBanner
      detail={about ? `${about}${about.endsWith('.') ? '' : ':'} ${detail}` : detail}
      fix={problem?.fix ? sentence(problem.fix) : fix}
      action={action}
      className={[inset ? 'inset' : '', className].filter(Boolean).join(' ')}
    />
  )
}
