import { Textarea, TextInput } from '@mantine/core'
import { useEffect, useRef, useState } from 'react'

import { Button } from '@/ui/Button'

import type { Question } from './api'
import classes from './Brief.module.css'
import { EFFECTS_ROWS, EVERYTHING, type Scene, scenesOf, tableOf, textsOf } from './values'

/** Text that is typed here: the server's own is taken only while nobody types. */
function useTyped(given: string, onChange: (text: string) => void) {
  const [text, setText] = useState(given)
  const focused = useRef(false)
  useEffect(() => {
    if (!focused.current) setText(given)
  }, [given])
  return {
    value: text,
    onFocus: () => {
      focused.current = true
    },
    onBlur: () => {
      focused.current = false
    },
    onChange: ({ currentTarget: { value } }: { currentTarget: { value: string } }) => {
      setText(value)
      onChange(value)
    },
  }
}

export interface FieldProps {
  question: Question
  value: unknown
  onChange: (value: unknown) => void
  /** Categories of the list and of other answers, for rows. */
  categories: readonly string[]
}

interface PlacedText {
  label: string
  value: string
  placeholder?: string
  onChange: (text: string) => void
}

export function NoteField({ label, value, onChange }: PlacedText) {
  return <TextInput label={label} {...useTyped(value, onChange)} maxLength={5000} />
}

export function ChoiceField({ question, value, onChange }: FieldProps) {
  const several = question.kind === 'choices'
  const picked = several ? textsOf(value) : [value]
  return (
    <div role="group" aria-label={question.text} className={`row wrap ${classes.choices}`}>
      {question.choices.map(({ key, label }) => {
        const isPicked = picked.includes(key)
        const next = several
          ? isPicked
            ? picked.filter((other) => other !== key)
            : [...picked, key]
          : isPicked
            ? ''
            : key
        return (
          <button
            key={key}
            type="button"
            className={`hover rounded pointer narrow-min-h-44px ${classes.choice}`}
            aria-pressed={isPicked}
            onClick={() => onChange(next)}
          >
            {label}
          </button>
        )
      })}
    </div>
  )
}

export function TextField({ question, value, onChange }: FieldProps) {
  const isLines = question.kind === 'lines'
  const given = isLines ? textsOf(value).join('\n') : typeof value === 'string' ? value : ''
  const typed = useTyped(given, (text) => onChange(isLines ? text.split('\n') : text))
  return (
    <Textarea
      aria-label={question.text}
      description={isLines ? 'One a line.' : undefined}
      rows={3}
      resize="vertical"
      {...typed}
    />
  )
}

export function NumberField({ question, value, onChange }: FieldProps) {
  const typed = useTyped(typeof value === 'number' ? String(value) : '', (text) => {
    const plain = text.trim().replace(',', '.')
    if (plain === '') onChange(null)
    else if (/^\d+(\.\d+)?$/.test(plain)) onChange(Number(plain))
  })
  const isNumber = typed.value.trim() === '' || /^\d+([.,]\d+)?$/.test(typed.value.trim())
  return (
    <div className={`row ${classes.amount}`}>
      <TextInput
        aria-label={`${question.text} In ${question.unit}.`}
        inputMode="decimal"
        error={isNumber ? undefined : 'Enter a number.'}
        {...typed}
      />
      <span>{question.unit}</span>
    </div>
  )
}

export function EffectsField({ question, value, onChange, categories }: FieldProps) {
  const table = tableOf(value)
  const own = Object.keys(table).filter((category) => category !== EVERYTHING)
  const rows = [EVERYTHING, ...own]
  const others = [...new Set([...categories, ...EFFECTS_ROWS])].filter((category) => !rows.includes(category))
  const of = (row: string) => table[row] ?? []
  return (
    <div className={`grid gap-2 overflow-x-auto ${classes.effects}`}>
      <table>
        <caption className="visually-hidden">{question.text}</caption>
        <thead>
          <tr>
            <th scope="col" className="small mid">
              Kind of sound
            </th>
            {question.choices.map(({ key, label }) => (
              <th key={key} scope="col" className="small mid">
                {label}
              </th>
            ))}
            <th>
              <span className="visually-hidden">Remove</span>
            </th>
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={row}>
              <th scope="row" className={row === EVERYTHING ? 'strong' : undefined}>
                {row === EVERYTHING ? 'Everything' : row}
              </th>
              {question.choices.map(({ key, label }) => (
                <td key={key}>
                  <input
                    type="checkbox"
                    className={classes.tick}
                    aria-label={`${label} on ${row === EVERYTHING ? 'everything' : row}`}
                    checked={of(row).includes(key)}
                    onChange={({ currentTarget: { checked } }) =>
                      onChange({
                        ...table,
                        [row]: checked ? [...of(row), key] : of(row).filter((other) => other !== key),
                      })
                    }
                  />
                </td>
              ))}
              <td>
                {row !== EVERYTHING && (
                  <Button
                    square
                    variant="quiet"
                    icon="cross"
                    aria-label={`Remove ${row}`}
                    onClick={() => onChange(Object.fromEntries(Object.entries(table).filter(([key]) => key !== row)))}
                  />
                )}
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      <div className="row wrap">
        {table[EVERYTHING] === undefined && (
          <Button onClick={() => onChange({ ...table, [EVERYTHING]: [] })}>No engine effects</Button>
        )}
        {others.map((category) => (
          <Button
            key={category}
            variant="quiet"
            icon="plus"
            onClick={() => onChange({ ...table, [category]: of(EVERYTHING) })}
          >
            {category}
          </Button>
        ))}
      </div>
    </div>
  )
}

export function ScenesField({ value, onChange }: FieldProps) {
  const [rows, setRows] = useState<Scene[]>(() => scenesOf(value))
  const focused = useRef(false)
  const given = JSON.stringify(scenesOf(value))
  useEffect(() => {
    if (!focused.current) setRows(JSON.parse(given) as Scene[])
  }, [given])
  const put = (at: number, change: Partial<Scene>) => {
    const next = [...rows, ...(at === rows.length ? [{ scene: '', ambience: '', music: false }] : [])]
    next[at] = { ...(next[at] ?? { scene: '', ambience: '', music: false }), ...change }
    setRows(next)
    const named = next.filter(({ scene, ambience }) => scene.trim() !== '' || ambience.trim() !== '')
    // A scene that has no name yet is kept here until it has one.
    if (named.every(({ scene }) => scene.trim() !== '')) onChange(named)
  }
  const holds = {
    onFocus: () => {
      focused.current = true
    },
    onBlur: () => {
      focused.current = false
    },
  }
  const shown = [...rows, { scene: '', ambience: '', music: false }]
  return (
    <div className="grid gap-2">
      {shown.map(({ scene, ambience, music }, at) => (
        <div
          key={at}
          className={`grid items-center gap-2 narrow-grid-cols-1 ${classes.scene}`}
          role="group"
          aria-label={scene || `Scene ${at + 1}`}
        >
          <input
            className={`bg-raised w-full border-edge rounded font-inherit ${classes.input}`}
            placeholder={at === 0 ? 'Harbour' : 'Another scene'}
            aria-label={`Scene ${at + 1}`}
            value={scene}
            maxLength={200}
            {...holds}
            onChange={({ currentTarget }) => put(at, { scene: currentTarget.value })}
          />
          <input
            className={`bg-raised w-full border-edge rounded font-inherit ${classes.input}`}
            placeholder={at === 0 ? 'Gulls, water on wood, distant ropes' : 'What is heard'}
            aria-label={`Ambience of ${scene || `scene ${at + 1}`}`}
            value={ambience}
            maxLength={1000}
            {...holds}
            onChange={({ currentTarget }) => put(at, { ambience: currentTarget.value })}
          />
          <label className="flex items-center gap-1">
            <input
              type="checkbox"
              className={classes.tick}
              checked={music}
              onChange={({ currentTarget }) => put(at, { music: currentTarget.checked })}
            />
            Music
          </label>
        </div>
      ))}
    </div>
  )
}
