import type { FieldChange } from './api'
import { fieldWord, valueWord } from './words'

interface ChangesProps {
  changes: readonly FieldChange[]
  /** Of a new cue: what it says, without a before. */
  fresh?: boolean
}

const hasValue = ({ after }: FieldChange): boolean => after !== null && after !== '' && after !== false

/** Facts before and after, one a line: "Length 0.80 s → 0.90 s". */
export function Changes({ changes, fresh = false }: ChangesProps) {
  return (
    <ul>
      {changes
        .filter((change) => !fresh || hasValue(change))
        .map(({ field, before, after }) => (
          <li key={field}>
            <span className="dim">{fieldWord(field)}</span>{' '}
            {!fresh && (
              <>
                <span className="visually-hidden">was </span>
                <span className="mid">{valueWord(field, before)}</span>
                <span aria-hidden="true"> → </span>
                <span className="visually-hidden">, now </span>
              </>
            )}
            <span>{valueWord(field, after)}</span>
          </li>
        ))}
    </ul>
  )
}
