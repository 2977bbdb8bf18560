/** Why a person signs in again: the session has ended, or what they do asks for a recent sign-in. */
export type SignInReason = 'ended' | 'recent'
/** Signs the person in again, in place; false where they would rather not. */
type SignInAgain = (reason: SignInReason) => Promise<boolean>

let ask: SignInAgain | null = null
let asking: Promise<boolean> | null = null
let signIns = 0

/** What is done while a page of a signed-in person is open, when the server asks them to sign in again. */
export function onSessionEnd(handler: SignInAgain): () => void {
  ask = handler
  return () => {
    if (ask === handler) ask = null
  }
}

/** The person signs out, and is not asked to sign in again. */
export function leaveSession(): void {
  ask = null
}

/** The number of sign-ins on this page: requests sent before the last one are repeated without asking. */
export const signInsSoFar = (): number => signIns

/** Whether a refused request may be sent again, since the same person has signed in. */
export async function signedInAgain(sentAfter = signIns, reason: SignInReason = 'ended'): Promise<boolean> {
  if (sentAfter !== signIns) return true
  if (ask === null) return false
  asking ??= ask(reason)
    .then((again) => {
      if (again) signIns += 1
      return again
    })
    .finally(() => (asking = null))
  return asking
}
