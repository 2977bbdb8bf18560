const KEPT = 'soundlist-project'

/** The project that was open last in this browser. */
export function lastProject(): string | null {
  try {
    return localStorage.getItem(KEPT)
  } catch {
    return null
  }
}

export function keepLastProject(id: string): void {
  try {
    localStorage.setItem(KEPT, id)
  } catch {
    // A browser that keeps nothing opens the first project.
  }
}
