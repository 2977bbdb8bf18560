import { EmptyState } from '@/ui/EmptyState'

import { ShellLink } from './shell/ShellLink'
import { StartPageLink } from './shell/StartPageLink'
import { useTitle } from './title'

/** No page has this address, or none that this person may see: the two look alike. */
export function NotFoundPage() {
  useTitle('Page not found')
  return (
    <div className="page page-narrow">
      <EmptyState
        head="Page not found"
        level={1}
        action={
          <>
            <StartPageLink />
            <ShellLink path="/projects" className="link">
              All projects
            </ShellLink>
          </>
        }
      >
        It may have been moved, or it belongs to a project you are not a member of.
      </EmptyState>
    </div>
  )
}
