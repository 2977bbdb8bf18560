import classes from './Count.module.css'

/** How many wait, in a quiet round badge; only for what the person can act on. */
export function Count({ of, what }: { of: number | string; what?: string }) {
  return (
    <span className={`ink ${classes.count} count`}>
      {of} {what && <span className="visually-hidden">{what}</span>}
    </span>
  )
}
