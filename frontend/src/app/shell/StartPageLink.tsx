import { ShellLink } from './ShellLink'

/** The way on from a page that cannot be shown. */
export function StartPageLink() {
  return (
    <ShellLink path="/" className="link">
      Go to the start page
    </ShellLink>
  )
}
