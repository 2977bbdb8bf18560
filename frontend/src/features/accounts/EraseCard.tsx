import { Link, type LinkProps } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'

import classes from './Account.module.css'

/** The way to the page on which an account or a studio is erased, which lists first what goes and what stays. */
export function EraseCard({ to, title }: { to: string; title: string }) {
  return (
    <Card aria-labelledby="erase-card">
      <CardHead id="erase-card" title={title} />
      <p className={`mid ${classes.inside} ${classes.note}`}>
        <Link className="link" to={to as LinkProps['to']}>
          See what is deleted and what stays
        </Link>
      </p>
    </Card>
  )
}
