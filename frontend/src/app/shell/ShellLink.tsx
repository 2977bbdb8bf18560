import { Link, type LinkProps } from '@tanstack/react-router'
import type { ReactNode } from 'react'

interface ShellLinkProps {
  path: string
  /** The page belongs to the screen that this leads to. */
  current?: boolean
  className?: string
  children: ReactNode
  'aria-label'?: string
}

/** A link by address: the shell stands below the features, so it does not know their routes by type. */
export function ShellLink({ path, current, ...rest }: ShellLinkProps) {
  const to = path as LinkProps['to']
  return <Link {...rest} to={to} activeOptions={{ exact: true }} {...(current && { 'aria-current': 'true' })} />
}
