interface Heard {
  variation: number | null
}

/** "shield_hit", or "shield_hit 3" of a set. */
export const titleOf = (sound: Heard & ({ cue_name: string } | { name: string })): string => {
  const name = 'cue_name' in sound ? sound.cue_name : sound.name
  return sound.variation === null ? name : `${name} ${sound.variation}`
}
