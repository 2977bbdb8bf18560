import { useState } from 'react'

import { Button } from '@/ui/Button'
import { useLazy } from '@/ui/useLazy'

import type { Cue } from './api'
import classes from './Unmatched.module.css'

interface CueFieldProps {
  projectId: string
  label: string
  /** A single file: of a set its variation is asked for. Several go to their own or the first empty ones. */
  one: boolean
  onPick: (cue: Cue, variation: number | null) => void
  onBack: () => void
}

const loadSearch = () => import('./CueSearch').then(({ CueSearch }) => CueSearch)

/** The list, searched by number, name or use; then the variation of a set. */
export function CueField({ projectId, label, one, onPick, onBack }: CueFieldProps) {
  const [cue, setCue] = useState<Cue | null>(null)
  const Search = useLazy(loadSearch, true, onBack)
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
    <div className="row">
      {Search && (
        <Search
          projectId={projectId}
          label={label}
          onPick={(found) => {
            if (one && found.stems.length > 1) setCue(found)
            else onPick(found, null)
          }}
          onBack={onBack}
        />
      )}
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
    <div className={`row wrap ${classes.acts}`} role="group" aria-label={`Variation of ${name}`}>
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
