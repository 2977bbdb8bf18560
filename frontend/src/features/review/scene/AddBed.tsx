import { NativeSelect } from '@mantine/core'
import { useQuery } from '@tanstack/react-query'

import { Field, Form, Submit } from '@/ui/Form'

import { type BedRole, type BedSource, bedSourcesQuery, useBeds } from './api'

interface AddBedProps {
  projectId: string
  category: string
  onDone: () => void
}

/** Put an approved sound, or one of the references, under the sounds of the project or of this category. */
export function AddBed({ projectId, category, onDone }: AddBedProps) {
  const sources = useQuery(bedSourcesQuery(projectId))
  const { set } = useBeds(projectId)
  const options = sources.data ?? []
  if (sources.data?.length === 0) {
    return (
      <p className="small mid">
        No sound is approved yet, and no sound stands on the references board. Add one there, then choose it here.
      </p>
    )
  }
  return (
    <Form
      className="flex wrap items-end gap-2"
      aria-label="Add a bed"
      initialValues={{ role: 'ambience', sound: '', under: 'project' }}
      mutation={{ isPending: set.isPending, error: set.error ?? sources.error }}
      onSubmit={({ role, sound, under }) => {
        const source = options.find((option) => idOf(option) === sound) ?? options[0]
        if (source === undefined) return
        const { take_id, reference_id } = source
        const bed = {
          role: role as BedRole,
          category: under === 'project' ? '' : category,
          take_id,
          reference_id,
          level_db: -12,
          is_on: true,
        }
        set.mutate(bed, { onSuccess: onDone })
      }}
    >
      <Field
        as={NativeSelect}
        name="role"
        label="Plays as"
        data={[
          { value: 'music', label: 'Music' },
          { value: 'ambience', label: 'Ambience' },
          { value: 'voice', label: 'Voice' },
        ]}
      />
      <Field
        as={NativeSelect}
        name="sound"
        label="Sound"
        data={options.map((option) => ({
          value: idOf(option),
          label: `${option.name}${option.reference_id ? ' (reference)' : option.loops ? ' (loop)' : ''}`,
        }))}
      />
      {category && (
        <Field
          as={NativeSelect}
          name="under"
          label="Under the sounds of"
          data={[
            { value: 'project', label: 'the whole project' },
            { value: 'category', label: category },
          ]}
        />
      )}
      <Submit disabled={options.length === 0} onCancel={onDone}>
        Add
      </Submit>
    </Form>
  )
}

const idOf = ({ take_id, reference_id }: BedSource): string => take_id ?? reference_id ?? ''
