import { useQuery } from '@tanstack/react-query'

import { contractsQuery } from '@/api/project'
import { EmptyState } from '@/ui/EmptyState'
import { Button } from '@/ui/Button'

import { useTitle } from '../title'

/** Whether a page shows something of a project that its NDA keeps closed; contracts are read before. */
export const isClosed = (pathname: string, projectId: string): boolean => {
  const project = `/projects/${projectId}`
  const isOfProject = pathname === project || pathname.startsWith(`${project}/`)
  return isOfProject && !`${pathname}/`.startsWith(`${project}/contracts/`)
}

/** In the place of every page of a project until its NDA is agreed: what waits, for whom, and the way to read it. */
export function NdaFirst({ projectId, go }: { projectId: string; go: (path: string) => void }) {
  useTitle('NDA required')
  const { data: contracts, isPending } = useQuery(contractsQuery(projectId))
  const nda = contracts?.findLast(({ kind, state }) => kind === 'nda' && state !== 'ended')
  const path = `/projects/${projectId}/contracts`
  if (isPending) return <h1 className="visually-hidden">NDA required</h1>
  if (nda === undefined || nda.state === 'draft') {
    return (
      <Closed head="Waiting for the studio’s NDA" action="Go to contracts" onAction={() => go(path)}>
        This project opens once both sides have signed its non-disclosure agreement. You get an email when the studio
        sends it. There is nothing for you to do until then.
      </Closed>
    )
  }
  const isMine = nda.waits_for.includes('designer')
  return (
    <Closed
      head={isMine ? 'Read and sign the NDA to see this project' : 'Waiting for the studio to sign the NDA'}
      action="Read the NDA"
      onAction={() => go(`${path}/${nda.id}`)}
    >
      {isMine
        ? 'You can see the brief, sound list and delivery spec once you and the studio have signed the non-disclosure agreement.'
        : 'You have signed. You can see the brief, sound list and delivery spec once the studio signs too.'}
    </Closed>
  )
}

interface ClosedProps {
  head: string
  action: string
  onAction: () => void
  children: string
}

function Closed({ head, action, onAction, children }: ClosedProps) {
  return (
    <div className="page page-narrow">
      <EmptyState
        head={head}
        level={1}
        action={
          <Button variant="primary" icon="file" onClick={onAction}>
            {action}
          </Button>
        }
      >
        {children}
      </EmptyState>
    </div>
  )
}
