import { Select } from '@mantine/core'
import type { ReactNode } from 'react'

import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { useCues } from './api'

interface CueSelectProps {
  projectId: string
  value: string | null
  onChange: (cueId: string | null) => void
  error?: ReactNode
  hasFocus: boolean
}

/** The cue that a question is about. */
export function CueSelect({ projectId, hasFocus, ...rest }: CueSelectProps) {
  const { data: cues } = useCues(projectId)
  const field = useFocusOnMount<HTMLInputElement>(hasFocus)
  return (
    <Select
      label="Cue"
      searchable
      data={cues?.map(({ id, label, name }) => ({ value: id, label: `${label} ${name}` })) ?? []}
      {...rest}
      ref={field}
      comboboxProps={{ transitionProps: { duration: 0 } }}
    />
  )
}
