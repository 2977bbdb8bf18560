import type { ReactNode } from 'react'

import { ApiProblem } from '@/api/problem'

import { Refusal } from './Refusal'

interface PageWaitProps {
  title: string
  /** The error of the page's query; while there is none, the page waits. */
  error: unknown
  /** The heading is the name of what the page shows: hidden while it waits, "Version not found" where it is not there. */
  isNamed?: boolean
  /** A way on from the error. */
  action?: ReactNode
}

/** A page whose first answer is not here: it waits, or says why there is none. */
export function PageWait({ title, error, isNamed = false, action }: PageWaitProps) {
  const isMissing = error instanceof ApiProblem && error.status === 404
  return (
    <div className="page stack" aria-busy={error === null}>
      <h1 className={isNamed && !error ? 'visually-hidden' : undefined}>
        {isNamed && isMissing ? `${title} not found` : title}
      </h1>
      <Refusal error={error} action={action} />
    </div>
  )
}
