import { outbox, REFUSED, WAITING } from './outbox'

/** The person is signed in: go on with what earlier pages left, if they left anything. */
export function resumeOutbox(personId: string, onLateAnswer: () => void): void {
  outbox.writer = { personId, onLateAnswer }
  const mine = [`${WAITING}:${personId}:`, `${REFUSED}:${personId}:`]
  try {
    if (!Object.keys(localStorage).some((key) => mine.some((prefix) => key.startsWith(prefix)))) return
  } catch {
    return // a browser that keeps nothing
  }
  void import('./offlineOutbox').then(({ offlineOutbox }) => offlineOutbox.begin())
}
