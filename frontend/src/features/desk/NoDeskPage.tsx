import { useTitle } from '@/app/title'
import { EmptyState } from '@/ui/EmptyState'

/** The desk of a person without an engagement. */
export function NoDeskPage() {
  useTitle('Desk')
  return (
    <div className="page">
      <EmptyState level={1} head="You are not a sound designer in any project yet.">
        A studio can invite you by email. The link shows the sound list right away.
      </EmptyState>
    </div>
  )
}
