import { type ErrorComponentProps, useRouter } from '@tanstack/react-router'

import { ApiProblem } from '@/api/problem'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'

import { NotFoundPage } from './NotFoundPage'
import { StartPageLink } from './shell/StartPageLink'
import { useTitle } from './title'

/** A page that could not be shown: what happened, and the ways on. */
export function ErrorPage({ error, reset }: ErrorComponentProps) {
  const router = useRouter()
  if (error instanceof ApiProblem && error.status === 404) return <NotFoundPage />
  const again = () => {
    reset()
    void router.invalidate()
  }
  return <Broken error={error} onAgain={again} />
}

function Broken({ error, onAgain }: { error: unknown; onAgain: () => void }) {
  useTitle('This page could not be loaded')
  const problem = error instanceof ApiProblem ? error : null
  return (
    <div className="page page-narrow" role="alert">
      <EmptyState
        head={problem?.status === 403 ? 'You don’t have access to this page.' : 'This page could not be loaded.'}
        level={1}
        action={
          <>
            <Button variant="primary" onClick={onAgain}>
              Try again
            </Button>
            <StartPageLink />
          </>
        }
      >
        {problem ? (
          <>
            {problem.detail} {problem.fix}
          </>
        ) : (
          'Something went wrong on our side. Your work is safe.'
        )}
      </EmptyState>
      <p className="micro dim mono">
        {problem ? problem.code : error instanceof Error ? error.message : String(error)}
      </p>
    </div>
  )
}
