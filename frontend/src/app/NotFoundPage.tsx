import { EmptyState } from '@/ui/EmptyState'

import { ShellLink } from './shell/ShellLink'
import { useTitle } from './title'

/** Nothing stands at this address, or nothing that this person may see: the two look alike. */
export function NotFoundPage() {
  useTitle('Nothing here')
  return (
    <div className="page page-narrow">
      <EmptyState
        head="Nothing stands at this address."
        level={1}
        action={
          <>
            <ShellLink path="/" className="link">
              To the start
            </ShellLink>
            <ShellLink path="/projects" className="link">
              All projects
            </ShellLink>
          </>
        }
      >
        It may have been moved, or it belongs to a project that you are not part of.
      </EmptyState>
    </div>
  )
}
