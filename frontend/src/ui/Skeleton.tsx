import classes from './Skeleton.module.css'

interface SkeletonProps {
  /** As many lines as will probably come. */
  rows?: number
}

/** Lines of a list or a text that is being loaded, shown after a moment; nothing moves. */
export function Skeleton({ rows = 4 }: SkeletonProps) {
  return (
    <div className={classes.rows} style={{ height: `calc(${rows} * var(--sl-skeleton-row))` }} aria-busy="true">
      <span className="visually-hidden">Loading</span>
    </div>
  )
}

/** A page whose parts are not known yet: its head, and lines below. */
export function PageSkeleton() {
  return (
    <div className="page" aria-busy="true">
      <span className="visually-hidden">Loading</span>
    </div>
  )
}
