import { Select } from '@mantine/core'

import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { useCues } from './api'

interface CueSelectProps {
  projectId: string
  chosen: string | null
  onChoose: (cueId: string | null) => void
  error?: string
  hasFocus: boolean
}

/** The cue that a question is about. */
export function CueSelect({ projectId, chosen, onChoose, error, hasFocus }: CueSelectProps) {
  const { data: cues } = useCues(projectId)
  const field = useFocusOnMount<HTMLInputElement>(hasFocus)
  return (
    <Select
      label="Cue"
      searchable
      data={cues?.map(({ id, label, name }) => ({ value: id, label: `${label} ${name}` })) ?? []}
      value={chosen}
      onChange={onChoose}
      error={error}
      ref={field}
      comboboxProps={{ transitionProps: { duration: 0 } }}
    />
  )
}
