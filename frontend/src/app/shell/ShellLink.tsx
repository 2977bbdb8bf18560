import { Link, type LinkProps } from '@tanstack/react-router'
import type { ReactNode } from 'react'

interface ShellLinkProps {
  path: string
  exact?: boolean
  className?: string
  children: ReactNode
  'aria-label'?: string
}

/** A link by address: the shell stands below the features, so it does not know their routes by type. */
export function ShellLink({ path, exact = false, ...rest }: ShellLinkProps) {
  return <Link {...rest} to={path as LinkProps['to']} activeOptions={{ exact }} />
}
