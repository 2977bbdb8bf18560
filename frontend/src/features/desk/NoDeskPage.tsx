import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'

/** The desk of somebody whom no project engaged. */
export function NoDeskPage() {
  useTitle('Desk')
  return (
    <div className="page">
      <EmptyState level={1} head="No project has you as its sound designer yet.">
        A studio invites you by mail. The link in it shows the sound list at once.
      </EmptyState>
    </div>
  )
}
