import type { QueueCount } from '@/verdicts/api'
import { capital, spelled } from '@/verdicts/words'

interface Counts {
  cues: QueueCount
  questions: number
  drafts: number
  mayApprove: boolean
  /** Questions are theirs to answer. */
  mayAnswer: boolean
  /** What else is named as a next step. */
  steps?: number
}

const many = (count: number, singular: string, plural: string): string =>
  `${spelled(count)} ${count === 1 ? singular : plural}`

/** What the day holds, in one or two sentences. */
export function headline({
  cues: { cues, is_all },
  questions,
  drafts,
  mayApprove,
  mayAnswer,
  steps = 0,
}: Counts): string {
  const sounds = cues > 0 ? (is_all ? '' : 'more than ') + many(cues, 'cue', 'cues') : ''
  const asked = questions > 0 ? many(questions, 'question', 'questions') : ''
  const waits = (count: number) => (count === 1 ? 'waits' : 'wait')
  const together = [sounds, asked].filter(Boolean).join(' and ')
  let first = steps > 0 ? `${capital(many(steps, 'step is', 'steps are'))} yours to take.` : 'Nothing to do.'
  if (together !== '' && (mayApprove || (cues === 0 && mayAnswer))) {
    first = `${capital(together)} ${waits(cues + questions)} for you.`
  } else if (asked !== '' && mayAnswer) {
    first = `${capital(asked)} ${waits(questions)} for you, ${sounds} for the approver.`
  } else if (together !== '') {
    first = `${capital(together)} ${waits(cues + questions)} for the approver.`
  }
  if (drafts === 0) return first
  return `${first} ${capital(many(drafts, 'change is', 'changes are'))} drafted and not sent yet.`
}
