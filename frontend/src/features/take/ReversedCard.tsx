import { Card, CardHead } from '@/ui/Card'
import { figure, score } from '@/ui/format'
import { Table } from '@/ui/Table'

import type { Check } from './api'
import { isTable, judgedOf } from './judged'
import classes from './Take.module.css'

/** What the judgement of direction goes by: how fast each octave rises, and falls. */
export function ReversedCard({ check }: { check: Check | null | undefined }) {
  const judged = check ? judgedOf(check.judgements, 'reversed') : null
  const bands = Array.isArray(judged?.evidence.bands) ? judged.evidence.bands.filter(isTable) : []
  if (!judged || bands.length === 0) return null
  const most = Math.max(1, ...bands.flatMap(({ rise_db_s: rise, fall_db_s: fall }) => [Number(rise), Number(fall)]))
  return (
    <Card aria-labelledby="reversed">
      <CardHead
        id="reversed"
        title="Reversed?"
        end={`${judged.verdict}${judged.score === null ? '' : `, score ${score(judged.score)}`}`}
      />
      <div className="p-3-inset-14px">
        <p className="small mid">
          The fastest rise and fall of each octave. Hits, shots and speech rise faster than they fall; reversed, they
          fall faster. <span className="nowrap">Press v to play it in reverse.</span>
        </p>
        <Table
          label="Rise and fall per octave"
          columns={[
            {
              head: 'Octave',
              rowHead: true,
              cell: ({ hz }) => (Number(hz) >= 1000 ? `${figure(Number(hz) / 1000)} kHz` : `${figure(Number(hz))} Hz`),
            },
            { head: 'Rises', numeric: true, cell: ({ rise_db_s: rise }) => `${figure(Number(rise))} dB/s` },
            { head: 'Falls', numeric: true, cell: ({ fall_db_s: fall }) => `${figure(Number(fall))} dB/s` },
            {
              head: <span className="visually-hidden">Rise beside fall</span>,
              className: classes.lean,
              cell: ({ rise_db_s: rise, fall_db_s: fall }) => (
                <span aria-hidden="true">
                  <i data-rise style={{ width: `${(100 * Number(rise)) / most}%` }} />
                  <i data-fall style={{ width: `${(100 * Number(fall)) / most}%` }} />
                </span>
              ),
            },
          ]}
          rows={bands}
          keyOf={({ hz }) => Number(hz)}
        />
      </div>
    </Card>
  )
}
