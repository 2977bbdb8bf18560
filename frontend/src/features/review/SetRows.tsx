import { WaveThumb } from '@/audio'
import type { ReviewCue, ReviewTake } from '@/verdicts/api'
import { MASTER, outlierOf, soundOf } from '@/verdicts/hearing'
import { measuredPart } from '@/verdicts/words'
import { ago, figure, length } from '@/ui/format'
import { Choice } from '@/ui/Choice'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'
import { SEVERITY_LOOK } from '@/ui/severity'

import classes from './Review.module.css'

interface SetRowsProps {
  takes: readonly ReviewTake[]
  handId: string | undefined
  nameOf: (take: ReviewTake) => string
  picked: ReadonlySet<string>
  onChoose: (take: ReviewTake) => void
  cue: ReviewCue
}

/** A set, one line a variation: they are heard against one another and accepted together. */
export function SetRows({ takes, handId, nameOf, picked, onChoose, cue }: SetRowsProps) {
  const odd = outlierOf(takes)
  const here = new Set(takes.map(({ variation }) => variation)).size
  return (
    <div className={`grid gap-6px flex-none ${classes.set}`}>
      <p className="row between small">
        <span className="strong">
          {here} of {cue.variations} variations
        </span>
        <span className="dim wide-only">
          hold <Key keys="h" /> to play randomised, as in game; <Key keys="x" /> selects
        </span>
      </p>
      <div className={classes.setRows} role="radiogroup" aria-label="Variations">
        {takes.map((take, index) => (
          <Choice
            key={take.id}
            className={classes.setRow}
            checked={take.id === handId}
            data-picked={picked.has(take.id) || undefined}
            onChoose={() => onChoose(take)}
          >
            <span className={`mono flex items-center between gap-6px border-r bg-well ${classes.setName}`}>
              {nameOf(take)}
              {index < 9 && <Key keys={String(index + 1)} />}
            </span>
            <span className="grid">
              <WaveThumb peaks={take.thumb} highlighted={take.id === handId} heightPx={24} />
            </span>
            <span className="small mid num">{length(soundOf(take, MASTER).durationS)}</span>
            <span className="small cut-text wide-only">
              {take.label !== null && `${take.label}, `}
              <CueProgress take={take} odd={odd?.take.id === take.id} />
            </span>
            <span className={`small flex items-center gap-1 ${classes.setPick}`}>
              {picked.has(take.id) ? (
                <>
                  <Icon name="tick" size={14} /> selected
                </>
              ) : (
                heardWords(take)
              )}
            </span>
          </Choice>
        ))}
      </div>
    </div>
  )
}

/** When a person heard a version: nobody approves a set of which one file was only seen. */
function heardWords({ is_heard: isHeard, heard_at: heardAt }: ReviewTake): string {
  if (!isHeard) return 'not heard'
  return heardAt === null ? 'heard just now' : `heard ${ago(heardAt)}`
}

function CueProgress({ take, odd }: { take: ReviewTake; odd: boolean }) {
  const away = take.away_from_set_lu
  const worst = take.findings.find(({ severity }) => severity === 'error') ?? take.findings[0]
  if (take.draft_change) return <span className="tone-change toned">draft change request</span>
  if (odd && away !== null) {
    return (
      <span className="tone-warn toned">
        {figure(Math.abs(away), 1)} dB {away > 0 ? 'louder' : 'softer'} than the others
      </span>
    )
  }
  if (worst) {
    const [measured, rest] = measuredPart(worst)
    return (
      <>
        <span className={`toned tone-${SEVERITY_LOOK[worst.severity].tone}`}>{measured}</span>
        <span className="dim">{rest}</span>
      </>
    )
  }
  if (take.state === 'approved') return <span className="dim">approved</span>
  return <span className="dim">{away === null ? 'conforming' : `${signed(away)} dB from the set`}</span>
}

const signed = (db: number): string => {
  const text = figure(db, 1)
  return db > 0 && text !== '0.0' ? `+${text}` : text
}
