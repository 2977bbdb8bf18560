import { PHASES } from '@/phases'
import { Autocomplete, Checkbox, NativeSelect, Textarea, TextInput } from '@mantine/core'

import { WordList } from '@/references'

import type { OwnColumn } from '../columns/api'
import { choicesOf } from '../columns/values'
import classes from './CueFields.module.css'
import type { CueDraft, DraftField, DraftValue, Faults } from './draft'
import { type CuePerson, TASKS } from '../people'
import { CHANNELS, fieldWord, NEEDS, REVERBS, SETTLED } from '../words'

interface CueFieldsProps {
  projectId: string
  draft: CueDraft
  faults: Faults
  categories: readonly string[]
  /** The project's own columns, in order. */
  columns?: readonly OwnColumn[]
  /** Who may be named. */
  people?: readonly CuePerson[]
  onChange: (field: DraftField, value: DraftValue) => void
}

/** Every fact of a cue in fields; what cannot be read stays as it was typed, with a sentence below. */
export function CueFields({
  projectId,
  draft,
  faults,
  categories,
  columns = [],
  people = [],
  onChange,
}: CueFieldsProps) {
  const text = (field: DraftField, place?: string) => ({
    label: fieldWord(field),
    className: place && classes[place],
    value: draft[field] as string,
    error: faults[field],
    onChange: (event: { currentTarget: { value: string } }) => onChange(field, event.currentTarget.value),
  })
  const flag = (field: DraftField, label: string) => (
    <Checkbox
      label={label}
      checked={draft[field] as boolean}
      onChange={(event) => onChange(field, event.currentTarget.checked)}
    />
  )
  return (
    <div className={`grid items-start ${classes.fields}`}>
      <TextInput {...text('name', 'two')} data-autofocus />
      <TextInput {...text('file_name', 'two')} placeholder="From the name" />
      <Autocomplete
        label={fieldWord('category')}
        value={draft.category}
        error={faults.category}
        data={[...categories]}
        onChange={(value) => onChange('category', value)}
      />
      <NativeSelect {...text('state')} size="xs" data={[...SETTLED]} />
      <NativeSelect {...text('need')} size="xs" data={[...NEEDS]} />
      <NativeSelect {...text('phase')} size="xs" data={[{ value: '', label: '–' }, ...PHASES]} />
      <TextInput {...text('use', 'two')} />
      <TextInput {...text('trigger', 'two')} />
      <TextInput {...text('duration_s')} label="Length, s" inputMode="decimal" />
      <TextInput {...text('duration_min_s')} label="At least, s" inputMode="decimal" />
      <TextInput {...text('duration_max_s')} label="At most, s" inputMode="decimal" />
      <TextInput {...text('variations')} inputMode="numeric" />
      <Textarea {...text('description', 'four')} rows={2} classNames={{ input: classes.grows }} />
      <div className={classes.four}>
        <WordList projectId={projectId} text={draft.description} />
      </div>
      <NativeSelect {...text('reverb')} size="xs" data={[...REVERBS]} />
      <NativeSelect {...text('channels')} size="xs" data={[...CHANNELS]} />
      <TextInput {...text('playback_priority')} inputMode="numeric" />
      <TextInput {...text('due_on')} type="date" />
      {TASKS.map(({ fact }) => (
        <NativeSelect
          key={fact}
          {...text(fact)}
          size="xs"
          data={[{ value: '', label: '–' }, ...people.map(({ id, name }) => ({ value: id, label: name }))]}
        />
      ))}
      <fieldset className={`flex wrap ${classes.flags}`}>
        <legend className="visually-hidden">Properties</legend>
        {flag('loop', 'Loop')}
        {flag('length_locked', 'Exact length')}
        {flag('placeholder', 'Placeholder in build')}
        {flag('palette', 'Part of the palette')}
      </fieldset>
      {columns.map((column) => {
        const choices = choicesOf(column)
        const shared = {
          label: column.name,
          value: draft.extra[column.name] ?? '',
          onChange: (event: { currentTarget: { value: string } }) =>
            onChange('extra', { ...draft.extra, [column.name]: event.currentTarget.value }),
        }
        return choices ? (
          <NativeSelect key={column.id} {...shared} size="xs" data={[{ value: '', label: '–' }, ...choices]} />
        ) : (
          <TextInput
            key={column.id}
            {...shared}
            type={column.kind === 'date' ? 'date' : 'text'}
            inputMode={column.kind === 'number' ? 'decimal' : undefined}
          />
        )
      })}
      {draft.length_locked && <TextInput {...text('frame_rate_fps')} placeholder="60" inputMode="decimal" />}
    </div>
  )
}
