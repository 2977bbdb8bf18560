import type { ReactNode } from 'react'

import { plural } from '@/ui/format'
import { Table } from '@/ui/Table'

import { axisOf, type MeasureFit, said, stands, type TakeFit, WHAT } from './fit'
import classes from './Fit.module.css'

const HEIGHT = 34
const MIDDLE = HEIGHT / 2
/** Room for a mark at either end, in percent of the width. */
const EDGE = 2

/** Where a sound lies among others, one axis a measure, and the same as a table. */
export function FitPicture({ fit }: { fit: TakeFit }) {
  return (
    <>
      <div className="grid gap-3">
        {fit.measures.map((measure) => (
          <Strip key={measure.measure} fit={measure} />
        ))}
      </div>
      <p className={`small mid flex wrap gap-1-4 ${classes.legend}`} aria-hidden="true">
        <span data-mark="own">this sound</span>
        <span data-mark="palette">palette</span>
        <span data-mark="other">other approved sounds</span>
        <span data-mark="reach">their range</span>
      </p>
      <FitTable fit={fit} />
    </>
  )
}

function Strip({ fit }: { fit: MeasureFit }) {
  const [from, to] = axisOf(fit)
  const x = (value: number) => `${EDGE + ((100 - 2 * EDGE) * (value - from)) / (to - from)}%`
  const reach = `${((100 - 2 * EDGE) * (fit.highest - fit.lowest)) / (to - from)}%`
  return (
    <figure className={classes.strip}>
      <figcaption className="row between small">
        <span className="strong">{WHAT[fit.measure]}</span>
        <span className={fit.stands === 'within' ? 'dim' : 'tone-warn toned'}>
          {said(fit.measure, fit.value)}, {stands(fit)}
        </span>
      </figcaption>
      <svg
        width="100%"
        height={HEIGHT}
        role="img"
        aria-label={`${WHAT[fit.measure]}: ${said(fit.measure, fit.value)}; ${plural(fit.others.length, 'other')} from ${said(fit.measure, fit.lowest)} to ${said(fit.measure, fit.highest)}`}
      >
        <line data-axis x1="0" x2="100%" y1={MIDDLE} y2={MIDDLE} />
        <rect data-reach x={x(fit.lowest)} width={reach} y={MIDDLE - 9} height={18} rx={3} />
        <line data-middle x1={x(fit.middle)} x2={x(fit.middle)} y1={MIDDLE - 9} y2={MIDDLE + 9} />
        {fit.others.map(({ cue, is_palette, value }) => (
          <circle key={cue.id} data-palette={is_palette || undefined} cx={x(value)} cy={MIDDLE} r={4}>
            <title>{`${cue.name}, ${said(fit.measure, value)}`}</title>
          </circle>
        ))}
        <svg x={x(fit.value)} y={MIDDLE} overflow="visible">
          <path data-own data-apart={fit.stands === 'within' ? undefined : true} d="M0 -9 L7 0 L0 9 L-7 0 Z" />
        </svg>
      </svg>
      <p className={`row between dim ${classes.ends}`} aria-hidden="true">
        <span>{said(fit.measure, from)}</span>
        <span>{said(fit.measure, to)}</span>
      </p>
    </figure>
  )
}

/** Every figure of the picture: this sound, then each that it is compared with. */
function FitTable({ fit: { measures, cue } }: { fit: TakeFit }) {
  const others = new Map(measures.flatMap((measure) => measure.others.map((sound) => [sound.cue.id, sound])))
  const rows: { id: string; name: ReactNode; valueOf: (fit: MeasureFit) => number | undefined }[] = [
    { id: 'this', name: <strong>{cue?.name}, this sound</strong>, valueOf: ({ value }) => value },
    { id: 'median', name: 'median of the others', valueOf: ({ middle }) => middle },
    ...[...others.values()].map(({ cue: sound, is_palette }) => ({
      id: sound.id,
      name: `${sound.name}${is_palette ? ', palette' : ''}`,
      valueOf: (fit: MeasureFit) => fit.others.find((candidate) => candidate.cue.id === sound.id)?.value,
    })),
  ]
  return (
    <details>
      <summary className="small pointer min-h-24px pt-3px">All figures by sound</summary>
      <Table
        label="This sound and the sounds it is compared with"
        columns={[
          { head: 'Sound', rowHead: true, cell: ({ name }) => name },
          ...measures.map((fit) => ({
            head: WHAT[fit.measure],
            numeric: true,
            cell: ({ valueOf }: (typeof rows)[number]) => {
              const value = valueOf(fit)
              return value === undefined ? 'not measured' : said(fit.measure, value)
            },
          })),
        ]}
        rows={rows}
        keyOf={({ id }) => id}
      />
    </details>
  )
}
