import { Card, CardHead } from '@/ui/Card'
import { figure, rate, score } from '@/ui/format'

import type { Check } from './api'
import { judgedOf, numberOf } from './judged'
import { meanSpectrumOf, SpectrumPlot } from './SpectrumPlot'

/** Where the spectrum ends, and how steeply: what the judgement of a lower rate goes by. */
export function UpsampledCard({ check }: { check: Check | null | undefined }) {
  const judged = check ? judgedOf(check.judgements, 'upsampled') : null
  const spectrum = meanSpectrumOf(judged?.evidence.spectrum)
  if (!judged || !spectrum) return null
  const edgeHz = numberOf(judged.figures.edge_hz)
  const dropDb = numberOf(judged.figures.drop_db)
  const fromHz = numberOf(judged.figures.from_hz)
  const sure = judged.score === null ? '' : `, score ${score(judged.score)}`
  const end =
    edgeHz === null || dropDb === null
      ? ''
      : `Its spectrum ends at ${figure(edgeHz / 1000, 1)} kHz, dropping by ${figure(dropDb, 1)} dB.`
  return (
    <Card aria-labelledby="upsampled">
      <CardHead id="upsampled" title="Upsampled?" end={`${judged.verdict}${sure}`} />
      <div className="p-3-inset-14px">
        <figure className="grid gap-2px">
          <SpectrumPlot spectrum={spectrum} edgeHz={edgeHz} end={end} />
          <figcaption className="small mid">
            {end}{' '}
            {fromHz !== null &&
              `That matches resampling from ${rate(fromHz)}. A pitched-down library sound or an old recorder can look the same: ask the designer.`}
          </figcaption>
        </figure>
      </div>
    </Card>
  )
}
