const KEPT = 'soundlist-visit:'

/** The visit that this tab began by a link; a reload does not open the link once more. */
export function keptVisit(secret: string): string | null {
  try {
    return sessionStorage.getItem(KEPT + secret)
  } catch {
    return null
  }
}

export function keepVisit(secret: string, visit: string | null): void {
  try {
    if (visit === null) sessionStorage.removeItem(KEPT + secret)
    else sessionStorage.setItem(KEPT + secret, visit)
  } catch {
    // The browser keeps nothing: a reload opens the link once more.
  }
}
