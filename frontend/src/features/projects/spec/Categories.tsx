import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import type { Cue } from '../api'
import { checksWithoutLimit, useChecks } from './checks'
import { Against, Choice, SeverityField, useWriting } from './fields'
import { AcceptFields, LimitFields } from './GroupFields'
import { differences, kindOf, SOUND_KINDS } from './say'
import classes from './SpecForm.module.css'
import { at, type Tables, tableIn } from './tables'
import { isAt } from './trouble'

const KINDS = [
  { value: '', label: 'not specified' },
  ...Object.entries(SOUND_KINDS).map(([value, label]) => ({ value, label })),
]

/** What one category asks otherwise than the spec at large. */
export function Categories({ cues, isAdding = false }: { cues: readonly Cue[]; isAdding?: boolean }) {
  const { tables, change } = useWriting()
  const [name, setName] = useState('')
  const named = Object.keys(tableIn(tables.categories))
  const unnamed = [...new Set(cues.map(({ category }) => category))].filter(
    (category) => category !== '' && !named.includes(category),
  )
  const slug = name.trim().toLowerCase().replace(/\s+/g, '_')
  const add = (category: string) => {
    if (category === '' || named.includes(category)) return
    // An empty table is a category all the same.
    change((whole) => ({ ...whole, categories: { ...tableIn(whole.categories), [category]: {} } }))
    setName('')
  }
  const form = (
    <form
      className={`row wrap ${classes.inside}`}
      onSubmit={(event) => {
        event.preventDefault()
        add(slug)
      }}
    >
      <TextInput
        aria-label="Category name"
        placeholder="Category name"
        value={name}
        spellCheck={false}
        onChange={({ currentTarget }) => setName(currentTarget.value)}
      />
      <Button type="submit" icon="plus">
        Add category
      </Button>
      {unnamed.length > 0 && <span className="small mid">In the sound list without rules:</span>}
      {unnamed.map((category) => (
        <button type="button" key={category} className="link small" onClick={() => add(category)}>
          {category}
        </button>
      ))}
    </form>
  )
  if (isAdding) return form
  return (
    <Card aria-labelledby="form-categories">
      <CardHead id="form-categories" title="Categories" note="overrides of the general rules" />
      {named.map((category) => (
        <Category key={category} name={category} cues={cues.filter((cue) => cue.category === category).length} />
      ))}
      {form}
    </Card>
  )
}

function Category({ name, cues }: { name: string; cues: number }) {
  const { tables, trouble } = useWriting()
  const base = ['categories', name]
  const wrong = isAt(trouble, base)
  const [opened, setOpened] = useState(false)
  const open = opened || wrong
  const checks = useChecks()
  const differs = differences(tables, name, checks)
  return (
    <details
      className={`border-b ${classes.category}`}
      open={open}
      onToggle={({ currentTarget }) => setOpened(currentTarget.open)}
    >
      <summary className={`flex wrap items-center hover p-2-inset pointer ${classes.summary}`}>
        <Icon name="right" />
        <span className="strong">{name}</span>
        <span className="small dim nowrap">{cues > 0 ? plural(cues, 'cue') : 'no cue'}</span>
        <span className="small mid grow">
          {[kindOf(tables, name), ...differs].filter(Boolean).join('; ') || 'same as general rules'}
        </span>
      </summary>
      {open && <CategoryFields name={name} />}
    </details>
  )
}

/** The rules of one category that differ from the general ones. */
export function CategoryFields({ name }: { name: string }) {
  const { tables, set, change } = useWriting()
  const base = ['categories', name]
  const checks = useChecks()
  const kind = at(tables, [...base, 'kind'])
  const remove = () =>
    change((whole: Tables) => {
      const { [name]: gone, ...left } = tableIn(whole.categories)
      return gone === undefined ? whole : { ...whole, categories: left }
    })
  return (
    <div className={classes.inside}>
      <div className={`items-start ${classes.two}`}>
        <Choice
          label="Sounds are"
          value={typeof kind === 'string' ? kind : ''}
          options={KINDS}
          onChange={(value) => set([...base, 'kind'], value === '' ? undefined : value)}
        />
        <AcceptFields base={base} />
      </div>
      <LimitFields base={base} />
      <ul className={`grid ${classes.checks}`}>
        {checksWithoutLimit(checks)
          .filter((check) => check.is_in_categories)
          .map(({ name: check, label, severity }) => (
            <li key={check}>
              <span>{label}</span>
              <SeverityField base={[...base, 'checks']} check={check} label={`${label} of ${name}`} usual={severity} />
            </li>
          ))}
      </ul>
      <Against place={base} />
      <Button variant="quiet" icon="cross" onClick={remove}>{`Remove ${name}`}</Button>
    </div>
  )
}
