import { useQuery } from '@tanstack/react-query'

import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { lengthAsked, plural } from '@/ui/format'
import { Row, Rows } from '@/ui/Rows'

import { askedCuesQuery, type AskedCue, type AskedLine } from './api'
import classes from './Hiring.module.css'
import { countOfLine } from './words'

interface AskedCardProps {
  lines: readonly AskedLine[]
  /** Whose cues are listed under each line; without it the lines are counts only. */
  postingId?: string
}

/** What bids are made on: each line with its counts, and the cues that it counts. */
export function AskedCard({ lines, postingId }: AskedCardProps) {
  const { data: asked, error } = useQuery({ ...askedCuesQuery(postingId ?? ''), enabled: postingId !== undefined })
  const cues = lines.reduce((sum, line) => sum + line.cues, 0)
  const concepts = lines.reduce((sum, line) => sum + line.concepts, 0)
  return (
    <Card aria-labelledby="asked">
      <CardHead id="asked" title="Asked for" end={plural(cues, 'cue')} />
      <Refusal error={error} />
      <Rows>
        {lines.map((line) => (
          <Row key={line.key}>
            {asked ? (
              <LineCues line={line} cues={asked.filter(({ line: key }) => key === line.key)} />
            ) : (
              <>
                <span className="grow">{line.label}</span>
                <span className="mid">{countOfLine(line)}</span>
              </>
            )}
          </Row>
        ))}
      </Rows>
      {concepts > 0 && (
        <p className="small tone-warn p-2-14px">
          {`${concepts} of ${plural(cues, 'cue')} ${concepts === 1 ? 'is a concept' : 'are concepts'} still: what is asked for may change.`}
        </p>
      )}
    </Card>
  )
}

function LineCues({ line, cues }: { line: AskedLine; cues: readonly AskedCue[] }) {
  return (
    <details className="grow">
      <summary className={`flex gap-3 pointer ${classes.asked}`}>
        <span className="grow">{line.label}</span>
        <span className="mid">{countOfLine(line)}</span>
      </summary>
      {cues.length !== line.cues && (
        <p className="small tone-warn">
          {`The sound list has changed since: it has ${plural(cues.length, 'cue')} for this line now.`}
        </p>
      )}
      <ul className={`small grid gap-1 ${classes.cues}`} aria-label={`Cues of ${line.label}`}>
        {cues.map((cue) => (
          <li key={cue.id}>
            <span>{cue.name}</span> <span className="mid">{factsOf(cue)}</span>
          </li>
        ))}
      </ul>
    </details>
  )
}

/** "4 files, 2.50 s each, loop". */
function factsOf({ variations, loop, is_concept: isConcept, ...lengths }: AskedCue): string {
  const suffix = variations > 1 ? ' each' : ''
  const asked = lengthAsked(lengths)
  const facts = [
    plural(variations, 'file'),
    asked === '' ? 'no length yet' : `${asked}${suffix}`,
    loop ? 'loop' : '',
    isConcept ? 'concept' : '',
  ]
  return facts.filter(Boolean).join(', ')
}
