import { Select } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Cue, useCues } from './api'
import classes from './Unmatched.module.css'

interface CueFieldProps {
  projectId: string
  label: string
  /** A single file: of a set its variation is asked for. Several go to their own or the first empty ones. */
  one: boolean
  onPick: (cue: Cue, variation: number | null) => void
  onBack: () => void
}

const optionOf = ({ id, label, name, use }: Cue) => ({ value: id, label: `${label} ${name}${use ? `, ${use}` : ''}` })

/** The list, searched by number, name or use; then the variation of a set. */
export function CueField({ projectId, label, one, onPick, onBack }: CueFieldProps) {
  const { data: cues } = useCues(projectId)
  const [cue, setCue] = useState<Cue | null>(null)
  const field = useFocusOnMount<HTMLInputElement>()
  if (cue !== null) {
    return (
      <VariationField
        name={cue.name}
        variations={cue.stems.length}
        onBack={() => setCue(null)}
        onPick={(variation) => onPick(cue, variation)}
      />
    )
  }
  return (
    <div className={classes.search}>
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
          if (!found) return
          if (one && found.stems.length > 1) setCue(found)
          else onPick(found, null)
        }}
        onKeyDown={(event) => {
          if (event.key === 'Escape') onBack()
        }}
      />
      <Button variant="quiet" onClick={onBack}>
        Back
      </Button>
    </div>
  )
}

interface VariationFieldProps {
  name: string
  variations: number
  onPick: (variation: number) => void
  onBack: () => void
}

/** Which of a set a file is: no default is chosen. */
export function VariationField({ name, variations, onPick, onBack }: VariationFieldProps) {
  return (
    <div className={classes.acts} role="group" aria-label={`Variation of ${name}`}>
      <span className="small mid">Which variation of {name}?</span>
      {Array.from({ length: variations }, (_, place) => (
        <Button key={place} onClick={() => onPick(place + 1)} aria-label={`Variation ${place + 1}`}>
          {String(place + 1).padStart(2, '0')}
        </Button>
      ))}
      <Button variant="quiet" onClick={onBack}>
        Back
      </Button>
    </div>
  )
}
