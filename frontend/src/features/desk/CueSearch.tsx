import { Select } from '@mantine/core'
import { useState } from 'react'

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
  // Held here: of its own the field is emptied whenever its list is read again.
  const [text, setText] = useState('')
  return (
    <Select
      className="grow"
      aria-label={label}
      placeholder="Number, name or use"
      searchable
      selectFirstOptionOnChange
      ref={field}
      searchValue={text}
      onSearchChange={setText}
      data={cues?.map(optionOf) ?? []}
      limit={50}
      nothingFoundMessage={cues === undefined ? 'The cues are being read.' : 'No cue matches.'}
      comboboxProps={{ transitionProps: { duration: 0 } }}
      onChange={(id) => {
        const cue = cues?.find((candidate) => candidate.id === id)
        if (cue) onPick(cue)
      }}
      onKeyDown={(event) => {
        if (event.key === 'Escape') onBack()
        // The first match is marked as one types; where the list came only after that, none is.
        if (event.key === 'Enter' && !event.currentTarget.hasAttribute('aria-activedescendant')) {
          const words = text.trim().toLowerCase()
          const cue = cues?.find((candidate) => optionOf(candidate).label.toLowerCase().includes(words))
          if (cue && words !== '') onPick(cue)
        }
      }}
    />
  )
}
