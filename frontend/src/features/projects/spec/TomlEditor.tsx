import type { Trouble } from './trouble'
import classes from './TomlEditor.module.css'
import { lineOf } from './places'

interface TomlEditorProps {
  toml: string
  onChange: (toml: string) => void
  trouble: Trouble | null
}

const LINE_PX = 18

/** The text of the spec with the numbers of its lines; the page scrolls, not the field. */
export function TomlEditor({ toml, onChange, trouble }: TomlEditorProps) {
  const count = toml.split('\n').length
  const wrong = trouble && lineOf(toml, trouble.place, trouble.message)
  return (
    <div className={`grid min-w-0 bg-well relative rounded-b-l ${classes.editor}`}>
      {wrong !== null && <div className={`tone-bad ${classes.wrong}`} style={{ top: 8 + (wrong - 1) * LINE_PX }} />}
      <pre className={`m-0 dim font-inherit num ${classes.numbers}`} aria-hidden="true">
        {Array.from({ length: count }, (_, index) => (
          <span key={index} data-wrong={index + 1 === wrong || undefined}>
            {`${index + 1}\n`}
          </span>
        ))}
      </pre>
      <textarea
        id="spec-toml"
        aria-label="Spec as TOML"
        aria-invalid={trouble !== null}
        aria-describedby={trouble ? 'spec-trouble' : undefined}
        className={`min-w-0 w-full overflow-x-auto border-0 ink font-inherit ${classes.text}`}
        value={toml}
        rows={count + 1}
        wrap="off"
        spellCheck={false}
        autoCapitalize="off"
        autoComplete="off"
        onChange={({ currentTarget }) => onChange(currentTarget.value)}
      />
    </div>
  )
}
