import { wordsOf } from '@/verdicts/findings'

import type { Finding } from './findings'

interface FindingLineProps {
  finding: Finding
  /** How to mend it, where that is said elsewhere. */
  fix?: string
}

/** One finding of a check that was made in this browser: what was measured, the limit, and how to fix it. */
export function FindingLine({ finding, fix = finding.fix }: FindingLineProps) {
  const { head, rest, where } = wordsOf({ ...finding, check: '', waived: false, fix })
  return (
    <p className={`tone-${finding.severity === 'error' ? 'bad' : 'warn'}`}>
      <span className="strong toned">
        <span className="visually-hidden">{finding.severity === 'error' ? 'Error: ' : 'Warning: '}</span>
        {head}.
      </span>{' '}
      <span className="mid">
        {rest}
        {where !== '' && ` At ${where}.`}
      </span>
    </p>
  )
}
