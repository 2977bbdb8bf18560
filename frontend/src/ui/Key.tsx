import classes from './Key.module.css'
import { capsOf } from './keyNames'

/** The cap of a key, or of each press of a sequence. Quiet to screen readers: the control names its keys itself. */
export function Key({ keys }: { keys: string }) {
  return (
    <>
      {capsOf(keys).map((cap, index) => (
        <kbd key={index} className={`mid nowrap flex-none rounded-s ${classes.key}`} aria-hidden="true">
          {cap}
        </kbd>
      ))}
    </>
  )
}
