import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { Select } from '@/ui/Select'

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
  const [role, setRole] = useState<BedRole>('ambience')
  const [chosen, setChosen] = useState('')
  const [isWide, setWide] = useState(true)
  const options = sources.data ?? []
  const source = options.find((option) => idOf(option) === chosen) ?? options[0]
  const problem = set.error ?? sources.error
  if (sources.data?.length === 0) {
    return (
      <p className="small mid">
        No sound is approved yet, and no sound stands on the references board. Add one there, then choose it here.
      </p>
    )
  }
  return (
    <form
      className="flex wrap items-end gap-2"
      aria-label="Add a bed"
      onSubmit={(event) => {
        event.preventDefault()
        if (source === undefined || set.isPending) return
        const { take_id, reference_id } = source
        const bed = { role, category: isWide ? '' : category, take_id, reference_id, level_db: -12, is_on: true }
        set.mutate(bed, { onSuccess: onDone })
      }}
    >
      <Select label="Plays as" value={role} onChange={(event) => setRole(event.currentTarget.value as BedRole)}>
        <option value="music">Music</option>
        <option value="ambience">Ambience</option>
        <option value="voice">Voice</option>
      </Select>
      <Select
        label="Sound"
        value={source ? idOf(source) : ''}
        onChange={(event) => setChosen(event.currentTarget.value)}
      >
        {options.map((option) => (
          <option key={idOf(option)} value={idOf(option)}>
            {option.name}
            {option.reference_id ? ' (reference)' : option.loops ? ' (loop)' : ''}
          </option>
        ))}
      </Select>
      {category && (
        <Select
          label="Under the sounds of"
          value={isWide ? 'project' : 'category'}
          onChange={(event) => setWide(event.currentTarget.value === 'project')}
        >
          <option value="project">the whole project</option>
          <option value="category">{category}</option>
        </Select>
      )}
      <Button type="submit" variant="primary" disabled={source === undefined || set.isPending}>
        Add
      </Button>
      <Button variant="quiet" onClick={onDone}>
        Cancel
      </Button>
      <Refusal error={problem} />
    </form>
  )
}

const idOf = ({ take_id, reference_id }: BedSource): string => take_id ?? reference_id ?? ''
