import { Checkbox } from '@mantine/core'
import { Link, useParams } from '@tanstack/react-router'
import { useId } from 'react'

import { Button } from '@/ui/Button'
import { Field, Form, Submit } from '@/ui/Form'

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
  return (
    <Form
      className="grid gap-3"
      aria-label="Sources"
      initialValues={{ ...NOTHING, ...initial }}
      mutation={{ isPending, error }}
      onSubmit={(sources) =>
        onSave({
          ...sources,
          libraries: sources.libraries.filter(({ name }) => name.trim()),
          generated: sources.generated.filter(({ tool }) => tool.trim()),
          performers: sources.performers.filter(({ name }) => name.trim()),
        })
      }
    >
      {(sources, change) => (
        <>
          <div className="flex wrap gap-2-4">
            <Field as={Checkbox} name="from_scratch" label="Made from scratch" />
            <Field as={Checkbox} name="own_recordings" label="Own recordings" />
          </div>
          <SourceRows
            title="Sound libraries"
            list="libraries"
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
            list="generated"
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
            list="performers"
            rowName="performer"
            fields={[
              ['name', 'Performer'],
              ['release', 'Release: its date or place'],
            ]}
            rows={sources.performers}
            empty={{ name: '', release: '' }}
            onChange={(performers) => change({ performers })}
          />
          <Field optional name="note" label="Note" />
          <Submit onCancel={onCancel}>Save sources</Submit>
        </>
      )}
    </Form>
  )
}

interface SourceRowsProps<Row extends Record<string, string>> {
  title: string
  /** The field that holds the rows. */
  list: keyof Sources
  /** What one row is called. */
  rowName: string
  fields: readonly (readonly [keyof Row & string, string])[]
  rows: readonly Row[]
  empty: Row
  onChange: (rows: Row[]) => void
}

function SourceRows<Row extends Record<string, string>>({
  title,
  list,
  rowName,
  fields,
  rows,
  empty,
  onChange,
}: SourceRowsProps<Row>) {
  const heading = useId()
  return (
    <div role="group" aria-labelledby={heading} className={`grid gap-2 ${classes.group}`}>
      <p id={heading} className="small strong">
        {title}
      </p>
      {rows.map((_, place) => (
        <div key={place} className={`flex wrap items-end gap-2 ${classes.row}`}>
          {fields.map(([name, label]) => (
            <Field key={name} optional name={`${list}.${place}.${name}`} label={label} />
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
