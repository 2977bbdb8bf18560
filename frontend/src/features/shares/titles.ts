interface Heard {
  variation: number | null
}

/** "shield_hit", or "shield_hit 3" of a set. */
export const titleOf = (one: Heard & ({ cue_name: string } | { name: string })): string => {
  const name = 'cue_name' in one ? one.cue_name : one.name
  return one.variation === null ? name : `${name} ${one.variation}`
}
