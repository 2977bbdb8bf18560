import { Card, CardHead } from '@/ui/Card'
import { figure, score } from '@/ui/format'

import type { Check } from './api'
import { isTable, judgedOf, numberOf } from './judged'
import { meanSpectrumOf, SpectrumPlot } from './SpectrumPlot'
import classes from './Take.module.css'

const WIDTH = 600
const HEIGHT = 120

/** Where a codec's frames stand, and where the spectrum ends: what the judgement of lossy coding goes by. */
export function LossyCard({ check }: { check: Check | null | undefined }) {
  const judged = check ? judgedOf(check.judgements, 'lossy') : null
  const frames = framesOf(judged?.evidence.frames)
  if (!judged || !frames) return null
  const codec = typeof judged.figures.codec === 'string' ? judged.figures.codec : null
  const lowPassHz = numberOf(judged.figures.low_pass_hz)
  const spectrum = meanSpectrumOf(judged.evidence.spectrum)
  const sure = judged.score === null ? '' : `, score ${score(judged.score)}`
  const end = lowPassHz === null ? '' : `It ends steeply at ${figure(lowPassHz / 1000, 1)} kHz.`
  return (
    <Card aria-labelledby="lossy">
      <CardHead id="lossy" title="Was it converted from a lossy file?" end={`${judged.verdict}${sure}`} />
      <div className="grid gap-3 p-3-inset-14px">
        <figure className="grid gap-2px">
          <FramesPlot frames={frames} />
          <figcaption className="small mid">
            How many spectral lines of {frames.codec} are empty, for each possible frame position.{' '}
            {codec === null
              ? 'No position stands out: no sign of that codec.'
              : `One position stands out, ${percent(frames.most)} against ${percent(numberOf(judged.figures.elsewhere_share))} elsewhere: a sign of ${codec}. If no other source exists, ask the designer.`}
          </figcaption>
        </figure>
        {spectrum && lowPassHz !== null && (
          <figure className="grid gap-2px">
            <SpectrumPlot spectrum={spectrum} edgeHz={lowPassHz} end={end} />
            <figcaption className="small mid">
              {end} Codecs cut off like this, but so do resamplers and filters; this alone proves nothing.
            </figcaption>
          </figure>
        )}
      </div>
    </Card>
  )
}

interface Frames {
  codec: string
  places: number
  shares: number[]
  most: number
}

function framesOf(value: unknown): Frames | null {
  if (!isTable(value) || typeof value.codec !== 'string' || !Array.isArray(value.shares)) return null
  const shares = value.shares.filter((share) => typeof share === 'number')
  return { codec: value.codec, places: numberOf(value.frame) ?? shares.length, shares, most: Math.max(0, ...shares) }
}

const percent = (share: number | null): string => `${figure(100 * (share ?? 0))} %`

/** One bar a place, or a few in a row: the share of silent lines, the tallest over the whole height. */
function FramesPlot({ frames: { codec, places, shares, most } }: { frames: Frames }) {
  const width = WIDTH / shares.length
  return (
    <div className={`bg-well overflow-hidden relative rounded-s ${classes.places}`}>
      <svg
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={`Share of silent lines of ${codec} at ${places} places, at most ${percent(most)}`}
      >
        {shares.map((share, at) => (
          <rect
            key={at}
            data-most={share === most || undefined}
            x={(at * width).toFixed(2)}
            width={Math.max(width * 0.7, 1).toFixed(2)}
            y={(HEIGHT * (1 - share / Math.max(most, 0.1))).toFixed(1)}
            height={((HEIGHT * share) / Math.max(most, 0.1)).toFixed(1)}
          />
        ))}
      </svg>
      <span className={`absolute rounded-2px bg-well dim ${classes.decayEnd}`} aria-hidden="true">
        {places} places
      </span>
    </div>
  )
}
