const last = new Map<string, string>()

/** The cue selected last, by project: the list and the pages of its cues keep to one place. */
export const lastCue = (projectId: string): string | null => last.get(projectId) ?? null

export function keepLastCue(projectId: string, cueId: string): void {
  last.set(projectId, cueId)
}
