import { day, plural } from '@/ui/format'

import type { Contract } from './api'

const DAY_MS = 24 * 3_600_000

/** Whole days from one instant to another, in words. */
function span(from: string, to: Date): string {
  const days = Math.floor((to.getTime() - Date.parse(from)) / DAY_MS)
  return days < 1 ? 'less than a day' : plural(days, 'day')
}

/** How long it took from first being sent to the last signature, or for whom it waits and since when. */
export function SignatureTime({ contract }: { contract: Contract }) {
  const time = contract.signature_time
  if (!time) return null
  return <p className="small mid">{words(contract, time)}</p>
}

function words(contract: Contract, { first_sent_at, waits_since }: NonNullable<Contract['signature_time']>): string {
  const sent = `First sent ${day(first_sent_at)}.`
  if (contract.agreed_at !== null)
    return `${sent} Time to signature: ${span(first_sent_at, new Date(contract.agreed_at))}.`
  if (waits_since === null || contract.waits_for.length === 0) return sent
  const parties = contract.waits_for.map((party) => (party === contract.my_party ? 'you' : `the ${party}`))
  return `${sent} Waiting for ${parties.join(' and ')} since ${day(waits_since)} (${span(waits_since, new Date())}).`
}
