import { useQuery } from '@tanstack/react-query'

import { Table } from '@/ui/Table'
import { Refusal } from '@/ui/Refusal'

import { lossQuery } from './api'
import { LossPlot } from './LossPlot'
import { type LossLine, linesOf, octavesOf } from './words'

/** What one game file lost: both spectra over each other, and every figure in a table. */
export function LossPanel({ renderId, target }: { renderId: string; target: string }) {
  const { data: loss, error } = useQuery(lossQuery(renderId))
  if (error) return <Refusal error={error} />
  if (loss === undefined) return null
  return (
    <div className="grid gap-2">
      <LossPlot spectra={loss.spectra} />
      <LossTable label={`Quality loss of the ${target} file`} head="Figure" lines={linesOf(loss)} />
      <details className="small">
        <summary className="pointer min-h-24px">Spectra as a table</summary>
        <LossTable label={`Spectra of master and file for ${target}`} head="Octave" lines={octavesOf(loss.spectra)} />
      </details>
    </div>
  )
}

function LossTable({ label, head, lines }: { label: string; head: string; lines: readonly LossLine[] }) {
  return (
    <Table
      label={label}
      rows={lines}
      keyOf={({ what }) => what}
      columns={[
        { head, rowHead: true, cell: ({ what }) => what },
        { head: 'Master', numeric: true, cell: ({ master }) => master ?? '' },
        { head: 'Game file', numeric: true, cell: ({ file }) => file },
      ]}
    />
  )
}
