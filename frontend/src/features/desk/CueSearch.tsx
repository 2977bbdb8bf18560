import { Select } from '@mantine/core'

import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Cue, useCues } from './api'

interface CueSearchProps {
  projectId: string
  label: string
  onPick: (cue: Cue) => void
  onBack: () => void
}

const optionOf = ({ id, label, name, use }: Cue) => ({ value: id, label: `${label} ${name}${use ? `, ${use}` : ''}` })

/** The cues of the project, searched by number, name or use. */
export function CueSearch({ projectId, label, onPick, onBack }: CueSearchProps) {
  const { data: cues } = useCues(projectId)
  const field = useFocusOnMount<HTMLInputElement>()
  return (
    <Select
      className="grow"
      aria-label={label}
      placeholder="Number, name or use"
      searchable
      ref={field}
      data={cues?.map(optionOf) ?? []}
      limit={50}
      nothingFoundMessage="No cue matches."
      comboboxProps={{ transitionProps: { duration: 0 } }}
      onChange={(id) => {
        const found = cues?.find((each) => each.id === id)
        if (found) onPick(found)
      }}
      onKeyDown={(event) => {
        if (event.key === 'Escape') onBack()
      }}
    />
  )
}
