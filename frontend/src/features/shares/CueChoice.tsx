import { TextInput } from '@mantine/core'
import { keptCuesQuery } from '@/api/soundList'
import { useQuery } from '@tanstack/react-query'
import type { ReactNode } from 'react'

import { plural } from '@/ui/format'
import { Select } from '@/ui/Select'

import { chosenCues, type CueFilter } from './choice'

interface CueChoiceProps {
  projectId: string
  value: CueFilter
  onChange: (filter: CueFilter) => void
  /** What does not fit. */
  error?: ReactNode
}

/** A filter of the list: words of the name, a category, one cue. It says what it gives now. */
export function CueChoice({ projectId, value: filter, onChange, error }: CueChoiceProps) {
  const { data: cues } = useQuery(keptCuesQuery(projectId))
  const categories = [...new Set((cues ?? []).map(({ category }) => category).filter(Boolean))].sort()
  const chosen = chosenCues(cues ?? [], filter)
  const only = cues?.find(({ id }) => id === filter.cueId)
  return (
    <fieldset className="grid gap-2 m-0 p-0 border-0">
      <legend className="small mid">Cues</legend>
      {only ? (
        <p className="row wrap">
          <span className="strong">{only.name}</span> <span className="small dim mono">{only.label}</span>
          <button type="button" className="link small" onClick={() => onChange({ ...filter, cueId: '' })}>
            Choose others
          </button>
        </p>
      ) : (
        <div className="grid items-end gap-3 grid-cols-fill-180px">
          <TextInput
            label="Name contains"
            value={filter.text}
            maxLength={200}
            onChange={(event) => onChange({ ...filter, text: event.currentTarget.value })}
          />
          <Select
            label="Category"
            value={filter.category}
            onChange={(event) => onChange({ ...filter, category: event.currentTarget.value })}
          >
            <option value="">All</option>
            {categories.map((category) => (
              <option key={category}>{category}</option>
            ))}
          </Select>
        </div>
      )}
      <p className="small mid" role="status">
        {cues === undefined
          ? ''
          : `${plural(chosen.length, 'cue')}${chosen.length > 0 && chosen.length <= 6 && !only ? `: ${chosen.map(({ name }) => name).join(', ')}` : ''}. Of each variation the approved version is heard, else the newest that conforms. Cues and versions that come later are not added.`}
      </p>
      {error && (
        <p className="small tone-bad toned" role="alert">
          {error}
        </p>
      )}
    </fieldset>
  )
}
