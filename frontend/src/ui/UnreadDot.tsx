import classes from './NowDot.module.css'

/** The orange dot before what comes first. */
export function NowDot() {
  return <span className={classes.dot} aria-hidden="true" />
}
