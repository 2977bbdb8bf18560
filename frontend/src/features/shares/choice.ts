export interface CueFilter {
  text: string
  category: string
  /** One cue alone; empty for those of the filter. */
  cueId: string
}

export const NO_FILTER: CueFilter = { text: '', category: '', cueId: '' }

interface ListedCue {
  id: string
  label: string
  name: string
  category: string
}

/** The cues that a filter gives. */
export function chosenCues<Cue extends ListedCue>(cues: readonly Cue[], { text, category, cueId }: CueFilter): Cue[] {
  if (cueId !== '') return cues.filter(({ id }) => id === cueId)
  const query = text.trim().toLowerCase()
  return cues.filter(
    (cue) =>
      (category === '' || cue.category === category) &&
      (cue.name.toLowerCase().includes(query) || cue.label.toLowerCase().includes(query)),
  )
}
