import { Textarea } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { Segmented } from '@/ui/Segmented'

import classes from './Brief.module.css'
import {
  correctedName,
  exampleOf,
  type Naming,
  namingFrom,
  namingOf,
  NO_NAMING,
  OFFERED,
  readName,
  type Token,
} from './naming'
import { fitInWords } from './words'

const SEPARATORS = [
  { value: '_', label: '_' },
  { value: '-', label: '-' },
  { value: '.', label: '.' },
] as const
const LETTERS = [
  { value: 'lower', label: 'lower' },
  { value: 'capital', label: 'Capital' },
  { value: 'any', label: 'any' },
] as const
const SHOWN = 6

interface NamesFieldProps {
  value: unknown
  onChange: (value: unknown) => void
  /** File names of the list, for the example. */
  names: readonly string[]
}

const shape = (token: Token) =>
  token.one_of ? token.one_of.join('/') : token.digits ? '1'.padStart(token.digits, '0') : token.repeats ? '1–n' : ''

/** How a file is named: parts that are clicked together, tried on the list as it stands. */
export function NamesField({ value, onChange, names }: NamesFieldProps) {
  const naming = namingOf(value)
  const { tokens, separator, extension } = naming
  const [isPasting, setPasting] = useState(false)
  const set = (change: Partial<Naming>) => onChange({ ...naming, ...change })
  const letters = tokens.find((token) => token.case)?.case ?? 'lower'
  const offered = OFFERED.filter(({ name }) => !tokens.some((token) => token.name === name))
  const misfits = names.filter((name) => readName(naming, name) === null)
  const fitting = names.filter((name) => !misfits.includes(name))
  const shown = [...misfits.slice(0, SHOWN), ...fitting.slice(0, Math.max(2, SHOWN - misfits.length))]
  const move = (at: number, by: -1 | 1) => {
    const next = [...tokens]
    const [taken] = next.splice(at, 1)
    if (taken) next.splice(at + by, 0, taken)
    set({ tokens: next })
  }
  return (
    <div className="stack">
      <div className="row wrap">
        {tokens.map((token, at) => (
          <span
            key={token.name}
            className={`inline-flex items-center gap-1 rounded ${classes.token}`}
            role="group"
            aria-label={`Part ${at + 1}: ${token.name}`}
          >
            {at > 0 && (
              <button
                type="button"
                className={`min-h-24px p-0 border-0 bg-none pointer ${classes.tokenAct}`}
                aria-label={`Move ${token.name} left`}
                onClick={() => move(at, -1)}
              >
                ‹
              </button>
            )}
            <span>
              {token.name} <span className="mono">{shape(token)}</span>
            </span>
            <button
              type="button"
              className={`min-h-24px p-0 border-0 bg-none pointer ${classes.tokenAct}`}
              aria-label={`Remove ${token.name}`}
              onClick={() => set({ tokens: tokens.filter((other) => other !== token) })}
            >
              ×
            </button>
          </span>
        ))}
        {tokens.length > 0 && <span className="mono mid">{extension}</span>}
        {offered.map((token) => (
          <Button
            key={token.name}
            icon="plus"
            onClick={() => set({ tokens: withToken(tokens, token.case ? { ...token, case: letters } : token) })}
          >
            {token.name}
          </Button>
        ))}
      </div>
      {tokens.length > 0 && (
        <>
          <div className="row wrap">
            <Segmented
              label="Between the parts"
              options={SEPARATORS}
              value={SEPARATORS.find((option) => option.value === separator)?.value ?? '_'}
              onChange={(next) => set({ separator: next })}
            />
            <Segmented
              label="Letters"
              options={LETTERS}
              value={LETTERS.find((option) => option.value === letters)?.value ?? 'lower'}
              onChange={(next) =>
                set({ tokens: tokens.map((token) => (token.case ? { ...token, case: next } : token)) })
              }
            />
            <span className="mid">
              As in <span className="mono">{exampleOf(naming)}</span>
            </span>
          </div>
          {names.length > 0 && (
            <>
              <ul className={`grid gap-1-4 ${classes.examples}`} aria-label="Names on the list">
                {shown.map((name) => (
                  <NameExample key={name} naming={naming} name={name} />
                ))}
              </ul>
              <p className="small mid" role="status">
                {fitInWords(fitting.length, names.length)}
              </p>
            </>
          )}
        </>
      )}
      <div>
        <button
          type="button"
          className="link small"
          aria-expanded={isPasting}
          onClick={() => setPasting((before) => !before)}
        >
          Paste names already in the code
        </button>
        {isPasting && (
          <PastedNames
            onUse={(read) => {
              onChange(read)
              setPasting(false)
            }}
          />
        )}
      </div>
    </div>
  )
}

/** The number of a variation stays last. */
function withToken(tokens: readonly Token[], added: Token): Token[] {
  const last = tokens.at(-1)
  return last?.name === 'variation' ? [...tokens.slice(0, -1), added, last] : [...tokens, added]
}

function NameExample({ naming, name }: { naming: Naming; name: string }) {
  const read = readName(naming, name)
  const corrected = read ? null : correctedName(naming, name)
  return (
    <li className={`row ${read ? 'tone-ok' : 'tone-bad'}`}>
      <span className="toned">
        <Icon name={read ? 'tick' : 'back'} />
      </span>
      <span className="mono">{name}</span>
      <span className="small mid">
        {read
          ? read.map((token) => token.name).join(', ')
          : corrected
            ? `does not fit; ${corrected} would`
            : 'does not fit'}
      </span>
    </li>
  )
}

function PastedNames({ onUse }: { onUse: (naming: Naming) => void }) {
  const [text, setText] = useState('')
  const read = text.trim() === '' ? null : namingFrom(text)
  return (
    <div className="stack">
      <Textarea
        label="File names, one a line"
        rows={4}
        resize="vertical"
        value={text}
        onChange={({ currentTarget }) => setText(currentTarget.value)}
      />
      <div className="row wrap">
        <Button disabled={read === null} onClick={() => onUse(read ?? NO_NAMING)}>
          Use this convention
        </Button>
        <span className="small mid" role="status">
          {text.trim() === ''
            ? ''
            : read
              ? `They read as ${exampleOf(read)}.`
              : 'These names have no convention in common. Click the parts together instead.'}
        </span>
      </div>
    </div>
  )
}
