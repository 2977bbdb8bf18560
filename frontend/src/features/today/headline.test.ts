import { expect, test } from 'vitest'

import { headline } from './headline'

const waits = (cues: number, is_all = true) => ({ cues, is_all })

test.each([
  [{ cues: waits(0), questions: 0, drafts: 0, mayApprove: true, mayAnswer: true }, 'Nothing to do.'],
  [
    { cues: waits(1), questions: 0, drafts: 1, mayApprove: true, mayAnswer: true },
    'One cue waits for you. One change is drafted and not sent yet.',
  ],
  [
    { cues: waits(14), questions: 2, drafts: 0, mayApprove: false, mayAnswer: false },
    '14 cues and two questions wait for the approver.',
  ],
  [
    { cues: waits(14), questions: 2, drafts: 0, mayApprove: false, mayAnswer: true },
    'Two questions wait for you, 14 cues for the approver.',
  ],
  [
    { cues: waits(0), questions: 0, drafts: 0, mayApprove: false, mayAnswer: true, steps: 2 },
    'Two steps are yours to take.',
  ],
  [
    { cues: waits(99, false), questions: 0, drafts: 0, mayApprove: true, mayAnswer: true },
    'More than 99 cues wait for you.',
  ],
])('the headline of %o', (counts, words) => {
  expect(headline(counts)).toBe(words)
})
