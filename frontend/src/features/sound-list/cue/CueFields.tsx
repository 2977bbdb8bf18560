import { Autocomplete, Checkbox, NativeSelect, Textarea, TextInput } from '@mantine/core'

import classes from './CueFields.module.css'
import type { CueDraft, DraftField, Faults } from './draft'
import { fieldWord, REVERBS, SETTLED } from '../words'

interface CueFieldsProps {
  draft: CueDraft
  faults: Faults
  categories: readonly string[]
  onChange: (field: DraftField, value: string | boolean) => void
}

/** Every fact of a cue in fields; what cannot be read stays as it was typed, with a sentence below. */
export function CueFields({ draft, faults, categories, onChange }: CueFieldsProps) {
  const text = (field: DraftField, place?: string) => ({
    label: fieldWord(field),
    className: place && classes[place],
    value: draft[field] as string,
    error: faults[field],
    onChange: (event: { currentTarget: { value: string } }) => onChange(field, event.currentTarget.value),
  })
  const flag = (field: DraftField, label: string) => (
    <Checkbox
      classNames={{ input: classes.box, label: classes.boxLabel }}
      label={label}
      checked={draft[field] as boolean}
      onChange={(event) => onChange(field, event.currentTarget.checked)}
    />
  )
  return (
    <div className={classes.fields}>
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
      <TextInput {...text('use', 'two')} />
      <TextInput {...text('trigger', 'two')} />
      <TextInput {...text('duration_s')} label="Length, s" inputMode="decimal" />
      <TextInput {...text('variations')} inputMode="numeric" />
      <Textarea {...text('description', 'four')} rows={2} classNames={{ input: classes.grows }} />
      <NativeSelect {...text('reverb')} size="xs" data={[...REVERBS]} />
      <TextInput {...text('playback_priority')} inputMode="numeric" />
      <TextInput {...text('due_on')} type="date" />
      <fieldset className={classes.flags}>
        <legend className="visually-hidden">Properties</legend>
        {flag('loop', 'Loop')}
        {flag('length_locked', 'Exact length')}
        {flag('placeholder', 'Placeholder in build')}
        {flag('palette', 'Part of the palette')}
      </fieldset>
      {draft.length_locked && <TextInput {...text('frame_rate_fps')} placeholder="60" inputMode="decimal" />}
    </div>
  )
}
