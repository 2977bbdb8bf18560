import { useQuery } from '@tanstack/react-query'

import { answered, api } from '@/api'
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
  useTitle('NDA first')
  const { data: contracts, isPending } = useQuery({
    queryKey: ['contracts', projectId],
    queryFn: () =>
      answered(api.GET('/v1/projects/{project_id}/contracts', { params: { path: { project_id: projectId } } })),
  })
  const nda = contracts?.findLast(({ kind, state }) => kind === 'nda' && state !== 'ended')
  const path = `/projects/${projectId}/contracts`
  if (isPending) return <h1 className="visually-hidden">NDA first</h1>
  if (nda === undefined || nda.state === 'draft') {
    return (
      <Closed head="The studio’s NDA is not here yet." action="To the contracts" onAction={() => go(path)}>
        This project opens once its non-disclosure agreement is agreed. When the studio sends it, a mail tells you;
        there is nothing for you to do until then.
      </Closed>
    )
  }
  const isMine = nda.waits_for.includes('designer')
  return (
    <Closed
      head={isMine ? 'Read and accept the NDA first.' : 'Your NDA waits for the studio.'}
      action="Read the NDA"
      onAction={() => go(`${path}/${nda.id}`)}
    >
      {isMine
        ? 'Brief, sound list and delivery spec of this project open once you and the studio have accepted its non-disclosure agreement.'
        : 'You accepted it. Brief, sound list and delivery spec open with the studio’s yes.'}
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
