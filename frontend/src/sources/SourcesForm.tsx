import { Checkbox, TextInput } from '@mantine/core'
import { Link, useParams } from '@tanstack/react-router'
import { useId, useState } from 'react'

import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import type { Sources } from './api'
import classes from './Sources.module.css'

interface SourcesFormProps {
  /** What the fields begin with. */
  initial: Sources | null
  error: unknown
  isPending: boolean
  onSave: (sources: Sources) => void
  onCancel: () => void
}

const NOTHING: Required<Sources> = {
  from_scratch: false,
  own_recordings: false,
  libraries: [],
  generated: [],
  performers: [],
  note: '',
}

/** Asks what sounds were made from; rows whose first field is empty are left out. */
export function SourcesForm({ initial, error, isPending, onSave, onCancel }: SourcesFormProps) {
  const { projectId } = useParams({ strict: false })
  const [sources, setSources] = useState<Required<Sources>>({ ...NOTHING, ...initial })
  const change = (changed: Partial<Sources>) => setSources((now) => ({ ...now, ...changed }))
  return (
    <form
      className={classes.form}
      aria-label="Sources"
      onSubmit={(event) => {
        event.preventDefault()
        onSave({
          ...sources,
          libraries: sources.libraries.filter(({ name }) => name.trim()),
          generated: sources.generated.filter(({ tool }) => tool.trim()),
          performers: sources.performers.filter(({ name }) => name.trim()),
        })
      }}
    >
      <div className="flex wrap gap-2-4">
        <Checkbox
          label="Made from scratch"
          checked={sources.from_scratch}
          onChange={({ currentTarget }) => change({ from_scratch: currentTarget.checked })}
        />
        <Checkbox
          label="Own recordings"
          checked={sources.own_recordings}
          onChange={({ currentTarget }) => change({ own_recordings: currentTarget.checked })}
        />
      </div>
      <SourceRows
        title="Sound libraries"
        rowName="library"
        fields={[
          ['name', 'Library'],
          ['licence', 'Licence'],
          ['file', 'File'],
        ]}
        rows={sources.libraries}
        empty={{ name: '', licence: '', file: '' }}
        onChange={(libraries) => change({ libraries })}
      />
      {projectId !== undefined && (
        <p className="small mid">
          <Link className="link" to="/projects/$projectId/libraries" params={{ projectId }} target="_blank">
            Register a library
          </Link>{' '}
          by fingerprints of its files (in a new tab), and versions that equal one say so.
        </p>
      )}
      <SourceRows
        title="Generated parts"
        rowName="generated part"
        fields={[
          ['tool', 'Tool and version'],
          ['part', 'Part of the sound'],
        ]}
        rows={sources.generated}
        empty={{ tool: '', part: '' }}
        onChange={(generated) => change({ generated })}
      />
      <SourceRows
        title="Performers"
        rowName="performer"
        fields={[
          ['name', 'Performer'],
          ['release', 'Release: its date or place'],
        ]}
        rows={sources.performers}
        empty={{ name: '', release: '' }}
        onChange={(performers) => change({ performers })}
      />
      <TextInput
        label="Note"
        value={sources.note}
        onChange={({ currentTarget }) => change({ note: currentTarget.value })}
      />
      <Refusal error={error} />
      <div className="flex wrap gap-2-4">
        <Button variant="primary" type="submit" disabled={isPending}>
          Save sources
        </Button>
        <Button variant="quiet" onClick={onCancel}>
          Cancel
        </Button>
      </div>
    </form>
  )
}

interface SourceRowsProps<Row extends Record<string, string>> {
  title: string
  /** What one row is called. */
  rowName: string
  fields: readonly (readonly [keyof Row & string, string])[]
  rows: readonly Row[]
  empty: Row
  onChange: (rows: Row[]) => void
}

function SourceRows<Row extends Record<string, string>>({
  title,
  rowName,
  fields,
  rows,
  empty,
  onChange,
}: SourceRowsProps<Row>) {
  const heading = useId()
  return (
    <div role="group" aria-labelledby={heading} className={classes.group}>
      <p id={heading} className="small strong">
        {title}
      </p>
      {rows.map((row, place) => (
        <div key={place} className={classes.row}>
          {fields.map(([name, label]) => (
            <TextInput
              key={name}
              label={label}
              value={row[name]}
              onChange={({ currentTarget: { value } }) =>
                onChange(rows.map((item, at) => (at === place ? { ...item, [name]: value } : item)))
              }
            />
          ))}
          <Button
            variant="quiet"
            icon="cross"
            aria-label={`Remove ${rowName} ${place + 1}`}
            onClick={() => onChange(rows.filter((_, at) => at !== place))}
          />
        </div>
      ))}
      <Button variant="quiet" icon="plus" onClick={() => onChange([...rows, empty])}>
        Add {rowName}
      </Button>
    </div>
  )
}
