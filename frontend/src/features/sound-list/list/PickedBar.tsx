import { useState } from 'react'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'

import { type Cue } from '../api'
import { type SharedField, useSetForSeveral } from '../import/api'
import { type CuePerson, TASKS } from '../people'
import classes from './SoundList.module.css'
import { ToolSelect } from './ToolSelect'
import { NEEDS, SETTLED } from '../words'

interface PickedBarProps {
  projectId: string
  cues: readonly Cue[]
  categories: readonly string[]
  people: readonly CuePerson[]
  onClear: () => void
}

/** How many cues are selected, and what can be said of all of them at once. */
export function PickedBar({ projectId, cues, categories, people, onClear }: PickedBarProps) {
  const [category, setCategory] = useState('')
  const set = useSetForSeveral(projectId)
  const live = cues.filter(({ state }) => state !== 'cut')
  const cut = cues.length - live.length

  const put = (field: SharedField, value: string | boolean, done: string) => {
    const differing = live.filter((cue) => valueOf(cue, field) !== value)
    if (set.isPending) return
    if (differing.length === 0) {
      showToast(`${plural(live.length, 'cue')} already had this value.`)
      return
    }
    const before = differing.map((cue) => ({ cue, value: valueOf(cue, field) }))
    set.mutate(
      { field, values: differing.map((cue) => ({ cue, value })) },
      {
        onSuccess: () =>
          showToast(`${plural(differing.length, 'cue')} ${done}.`, async () => {
            await set.mutateAsync({ field, values: before })
          }),
      },
    )
  }

  return (
    <>
      <section className={`row ${classes.tools} rounded bg-raised ${classes.picked}`} aria-label="Selected cues">
        <strong className="strong nowrap" role="status">
          {plural(cues.length, 'cue')} selected
        </strong>
        {cut > 0 && <span className="small dim nowrap">{cut} cut, not changed</span>}
        <form
          className="row"
          onSubmit={(event) => {
            event.preventDefault()
            const trimmed = category.trim()
            put(
              'category',
              trimmed.toLowerCase().replaceAll(' ', '-'),
              trimmed ? `in ${trimmed}` : 'without a category',
            )
          }}
        >
          <input
            className={`min-h-28px border-edge rounded bg-raised ink font-inherit ${classes.field}`}
            aria-label="Category for the selected cues"
            placeholder="Category"
            list="picked-categories"
            value={category}
            onChange={(event) => setCategory(event.currentTarget.value)}
          />
          <datalist id="picked-categories">
            {categories.map((option) => (
              <option key={option} value={option} />
            ))}
          </datalist>
          <Button type="submit">Set category</Button>
        </form>
        <ToolSelect
          label="Design status of the selected cues"
          value=""
          blank="Design status"
          isBlankDisabled
          options={SETTLED}
          onChoose={(value) => put('state', value, `set to ${value}`)}
        />
        <ToolSelect
          label="Need of the selected cues"
          value=""
          blank="Need"
          isBlankDisabled
          options={NEEDS}
          onChoose={(value) => put('need', value, `set to ${value}`)}
        />
        {TASKS.map(({ task, label }) => (
          <ToolSelect
            key={task}
            label={`${label}, of the selected cues`}
            value=""
            blank={label}
            isBlankDisabled
            options={people.map(({ id, name }) => ({ value: id, label: name }))}
            onChoose={(value) => {
              const id = value === 'none' ? '' : value
              const name = people.find((person) => person.id === id)?.name
              put(task, id, name === undefined ? 'set to no one' : `set to ${name}`)
            }}
          >
            <option value="none">No one</option>
          </ToolSelect>
        ))}
        <Button
          icon="dashedSquare"
          onClick={() => put('placeholder', true, 'marked as having a placeholder in the build')}
        >
          Placeholder
        </Button>
        <Button onClick={() => put('placeholder', false, 'marked as having no placeholder')}>No placeholder</Button>
        <Button onClick={() => put('palette', true, 'added to the palette')}>Add to palette</Button>
        <Button onClick={() => put('palette', false, 'removed from the palette')}>Remove from palette</Button>
        <Button className="end" keys="Escape" onClick={onClear}>
          Clear
        </Button>
      </section>
      <Refusal error={set.error} />
    </>
  )
}

function valueOf(cue: Cue, field: SharedField): string | boolean {
  if (field === 'implementer') return cue.implementer_id ?? ''
  return field === 'recorder' ? (cue.recorder_id ?? '') : cue[field]
}
