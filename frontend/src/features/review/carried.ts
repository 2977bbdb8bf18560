import type { CommentMark } from '@/audio'
import type { CarriedNote, ReviewTake } from '@/verdicts/api'

/** A note on an earlier version, where it stands in the one that is heard. */
export interface Carried {
  note: CarriedNote
  /** Its number in the wave, after those of this version; what is of the whole sound has none. */
  number: number | null
  startS: number | null
  endS: number | null
}

/** What is carried over to a version: what is not done yet, and what was said of this version to be done. */
export function carriedTo(
  notes: readonly CarriedNote[],
  take: Pick<ReviewTake, 'variation' | 'number'>,
  durationS: number,
  numberedBefore: number,
): Carried[] {
  let number = numberedBefore
  return notes
    .filter(
      ({ variation, number: of, answer }) =>
        variation === take.variation && of < take.number && !(answer?.is_done && answer.number < take.number),
    )
    .map((note) => ({
      note,
      number: note.start_s === null ? null : (number += 1),
      startS: note.start_s === null ? null : Math.min(note.start_s, durationS),
      endS: note.end_s === null ? null : Math.min(note.end_s, durationS),
    }))
}

/** Their markers in the waveform. */
export function carriedMarks(carried: readonly Carried[]): CommentMark[] {
  return carried.flatMap(({ note, number, startS, endS }) =>
    number === null || startS === null
      ? []
      : [{ id: note.id, number, startS, endS: endS !== null && endS > startS ? endS : undefined }],
  )
}

/** Whether it was said of this very version whether it is done. */
export const isAnswered = ({ note }: Carried, take: Pick<ReviewTake, 'number'>): boolean =>
  note.answer?.number === take.number
