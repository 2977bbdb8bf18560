import type { QueueCount } from '@/judging/api'
import { capital, spelled } from '@/judging/words'

interface Counts {
  cues: QueueCount
  questions: number
  drafts: number
  mayDecide: boolean
}

const many = (count: number, one: string, more: string): string => `${spelled(count)} ${count === 1 ? one : more}`

/** What the day holds, in one or two sentences. */
export function headline({ cues: { cues, is_all }, questions, drafts, mayDecide }: Counts): string {
  const waiting = [
    cues > 0 ? (is_all ? '' : 'more than ') + many(cues, 'cue', 'cues') : '',
    questions > 0 ? many(questions, 'question', 'questions') : '',
  ].filter(Boolean)
  const whom = mayDecide || cues === 0 ? 'you' : 'the approver'
  const first =
    waiting.length === 0
      ? 'Nothing waits for you.'
      : `${capital(waiting.join(' and '))} ${cues + questions === 1 ? 'waits' : 'wait'} for ${whom}.`
  if (drafts === 0) return first
  return `${first} ${capital(many(drafts, 'change is', 'changes are'))} noted and not sent yet.`
}
