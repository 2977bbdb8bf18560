import { useQuery } from '@tanstack/react-query'
import { keptCuesQuery } from '@/api/soundList'

import { Select } from '@/ui/Select'

import type { Pin } from './pins'

interface PinSelectProps {
  projectId: string
  pin: Pin
  onPin: (pin: Pin) => void
}

/** What a reference is for: the whole project, a category of the list, or one cue. */
export function PinSelect({ projectId, pin, onPin }: PinSelectProps) {
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const categories = [...new Set((cues ?? []).map(({ category }) => category).filter(Boolean))].toSorted()
  return (
    <Select label="Pin to" value={pin} onChange={(event) => onPin(event.currentTarget.value)}>
      <option value="">Whole project</option>
      {categories.length > 0 && (
        <optgroup label="Category">
          {categories.map((category) => (
            <option key={category} value={`category:${category}`}>
              {category}
            </option>
          ))}
        </optgroup>
      )}
      {(cues?.length ?? 0) > 0 && (
        <optgroup label="Cue">
          {cues?.map(({ id, label, name }) => (
            <option key={id} value={`cue:${id}`}>
              {label} {name}
            </option>
          ))}
        </optgroup>
      )}
    </Select>
  )
}
