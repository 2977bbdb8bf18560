import type { QueueCount } from '@/judging/api'
import { capital, spelled } from '@/judging/words'

interface Counts {
  cues: QueueCount
  questions: number
  drafts: number
  mayApprove: boolean
}

const many = (count: number, one: string, more: string): string => `${spelled(count)} ${count === 1 ? one : more}`

/** What the day holds, in one or two sentences. */
export function headline({ cues: { cues, is_all }, questions, drafts, mayApprove }: Counts): string {
  const waiting = [
    cues > 0 ? (is_all ? '' : 'more than ') + many(cues, 'cue', 'cues') : '',
    questions > 0 ? many(questions, 'question', 'questions') : '',
  ].filter(Boolean)
  const whom = mayApprove || cues === 0 ? 'you' : 'the approver'
  const first =
    waiting.length === 0
      ? 'Nothing to do.'
      : `${capital(waiting.join(' and '))} ${cues + questions === 1 ? 'waits' : 'wait'} for ${whom}.`
  if (drafts === 0) return first
  return `${first} ${capital(many(drafts, 'change is', 'changes are'))} drafted and not sent yet.`
}
