import { expect, test } from 'vitest'

import { type Awaited, awaitedWords, type NextStep, wordsOf } from './nextSteps'

const step = (kind: NextStep['kind'], count: number) =>
  ({ kind, count, subject: 'Effects', who: 'Designer', contract_id: null, posting_id: 'p1' }) as NextStep

test.each<[NextStep['kind'], string, string, string]>([
  [
    'answer_candidates',
    'Answer 0 questions of candidates',
    'Answer a candidate’s question',
    'Answer 2 questions of candidates',
  ],
  ['compare_bids', 'Compare 0 bids', 'Look at a bid', 'Compare 2 bids'],
  [
    'propose_changes',
    '0 things changed under Effects',
    'Something changed under Effects',
    '2 things changed under Effects',
  ],
  ['agree_days', 'Agree to 0 logged days', 'Agree to 1 logged day', 'Agree to 2 logged days'],
  ['agree_hours', 'Agree to 0 entries of hours', 'Agree to logged hours', 'Agree to 2 entries of hours'],
  [
    'correct_work',
    'Correct 0 entries that were refused',
    'Correct work that was refused',
    'Correct 2 entries that were refused',
  ],
  ['answer_questions', 'Answer 0 questions', 'Answer a question', 'Answer 2 questions'],
  [
    'answer_follow_ups',
    'Answer 0 questions about the brief',
    'Answer a question about the brief',
    'Answer 2 questions about the brief',
  ],
  ['send_changes', 'Send 0 changes', 'Send 1 change', 'Send 2 changes'],
  ['review', 'Review 0 cues', 'Review 1 cue', 'Review 2 cues'],
  ['fix', 'Fix 0 sounds', 'Fix 1 sound', 'Fix 2 sounds'],
  ['match', 'Choose cues for 0 files', 'Choose a cue for 1 file', 'Choose cues for 2 files'],
  ['record', 'Record 0 sounds', 'Record a sound', 'Record 2 sounds'],
  [
    'implement',
    'Put 0 accepted sounds in the game',
    'Put an accepted sound in the game',
    'Put 2 accepted sounds in the game',
  ],
  ['make', 'Make 0 sounds', 'Make 1 sound', 'Make 2 sounds'],
])('the step %s agrees with none, one and two', (kind, none, one, two) => {
  expect([0, 1, 2].map((count) => wordsOf(step(kind, count), 'p1').head)).toEqual([none, one, two])
})

test.each<[Awaited['kind'], string, string, string]>([
  ['verdicts', 'to judge 0 cues', 'to judge 1 cue', 'to judge 2 cues'],
  ['answer', 'to answer 0 questions', 'to answer 1 question', 'to answer 2 questions'],
  ['fixes', 'to fix 0 cues', 'to fix 1 cue', 'to fix 2 cues'],
])('what is awaited, %s, agrees with none, one and two', (kind, none, one, two) => {
  const awaited = (count: number) => ({ kind, count, subject: 'Effects' }) as Awaited
  expect([0, 1, 2].map((count) => awaitedWords(awaited(count)))).toEqual([none, one, two])
})
