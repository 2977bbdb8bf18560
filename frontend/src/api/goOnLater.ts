import { later, REFUSED, WAITING } from './later'

/** The person is signed in: go on with what earlier pages left, if they left anything. */
export function goOnLater(personId: string, onLateAnswer: () => void): void {
  later.writer = { personId, onLateAnswer }
  const mine = [`${WAITING}:${personId}:`, `${REFUSED}:${personId}:`]
  try {
    if (!Object.keys(localStorage).some((key) => mine.some((prefix) => key.startsWith(prefix)))) return
  } catch {
    return // a browser that keeps nothing
  }
  void import('./laterWrites').then(({ laterWrites }) => laterWrites.begin())
}
