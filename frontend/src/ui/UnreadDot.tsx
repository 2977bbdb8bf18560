import classes from './UnreadDot.module.css'

/** The orange dot before what comes first. */
export function UnreadDot() {
  return <span className={`flex-none ${classes.dot}`} aria-hidden="true" />
}
