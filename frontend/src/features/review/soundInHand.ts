import type { ReviewTake } from '@/verdicts/api'
import { soundOf } from '@/verdicts/hearing'

/** A place in the sound; its very start and end mean the whole of it. */
export function inside(positionS: number, take: ReviewTake | undefined, target: string): number {
  if (take === undefined) return 0
  return positionS > 0 && positionS < soundOf(take, target).durationS ? positionS : 0
}

/** Why a version has nothing to play. */
export function whySilent(take: ReviewTake, target: string): string {
  const { refusal } = soundOf(take, target)
  return refusal ? `This game file does not exist: ${refusal}` : 'The preview is not ready yet.'
}
