import { Key } from './Key'
import classes from './KeysLine.module.css'

/** A quiet line of the keys that matter here, at most seven. */
export function KeysLine({ keys }: { keys: readonly { keys: readonly string[]; label: string }[] }) {
  return (
    <p className={`flex wrap items-center gap-1-4 dim text-small ${classes.line}`}>
      {keys.slice(0, 7).map((hint) => (
        <span key={hint.label}>
          {hint.keys.map((key) => (
            <Key key={key} keys={key} />
          ))}
          <span className="visually-hidden">{hint.keys.join(', ')}: </span>
          {hint.label}
        </span>
      ))}
    </p>
  )
}
