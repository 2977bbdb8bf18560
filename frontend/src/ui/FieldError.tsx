import classes from './FieldError.module.css'
import { Icon } from './Icon'

interface FieldErrorProps {
  /** For `aria-describedby` of the field. */
  id?: string
  /** What does not fit, in a sentence. */
  children: string
  /** What it should be, taken with one press. */
  correction?: { label: string; apply: () => void }
}

/** The sentence below a field; what was typed stays as it is. */
export function FieldError({ id, children, correction }: FieldErrorProps) {
  return (
    <div className={`flex items-start gap-6px tone-bad mt-6px toned ${classes.error}`}>
      <Icon name="back" />
      <div>
        <span id={id} role="alert">
          {children}
        </span>{' '}
        {correction && (
          <button type="button" className="link" onClick={correction.apply}>
            {correction.label}
          </button>
        )}
      </div>
    </div>
  )
}
