import { useState } from 'react'

import { type Clock, type FindingMark, finePeaks, type Player, Waveform } from '@/audio'
import { usePeaks } from '@/verdicts/peaks'
import { length } from '@/ui/format'
import { Segmented } from '@/ui/Segmented'

import type { Fix, Shape, SoundBrief, Spot } from './api'
import classes from './Fix.module.css'
import type { Fixing } from './useFixing'
import { spotName } from './words'

interface Before {
  name: string
  durationS: number
  peaksUrl: string | null
}

interface FixWavesProps {
  before: Before
  fix: Fix
  sound: SoundBrief
  fixing: Fixing
  player: Player
  findings: readonly FindingMark[]
  limitDbfs?: number
}

const share = (part: number, whole: number) => `${(part / Math.max(whole, 1e-9)) * 100}%`

/** A take and its fixed copy on one axis of time; hatched is what goes. Below them the spots, as near as it takes. */
export function FixWaves({ before, fix, sound, fixing, player, findings, limitDbfs }: FixWavesProps) {
  const peaks = usePeaks(before.peaksUrl)
  const fixedPeaks = usePeaks(sound.peaks_url)
  const { cut_head_s: headS, cut_tail_s: tailS } = fix
  const fixedS = sound.duration_s ?? before.durationS - headS - tailS
  const clock = (side: 'before' | 'fixed'): Clock | undefined => (fixing.side === side ? player : undefined)
  const cuts = [
    { startS: 0, endS: headS },
    { startS: before.durationS - tailS, endS: before.durationS },
  ].filter(({ startS, endS }) => endS > startS)
  return (
    <div className={`grid gap-6px ${classes.waves}`}>
      <div className={`grid items-end gap-10px narrow-grid-cols-1 ${classes.line}`}>
        <p className={`grid text-small leading-small ${classes.side}`}>
          Original <span className="dim">{length(before.durationS)}</span>
        </p>
        <Waveform
          label={`${before.name}, original`}
          peaks={peaks}
          durationS={before.durationS}
          findings={findings}
          cuts={cuts}
          limitDbfs={limitDbfs}
          clock={clock('before')}
          playheadS={0}
          onSeek={(s) => fixing.hear('before', s)}
          onMark={(s) => fixing.hear('before', s)}
          heightPx={76}
          still={fixing.side !== 'before'}
          plain
        />
      </div>
      <div className={`grid items-end gap-10px narrow-grid-cols-1 ${classes.line}`}>
        <p className={`grid text-small leading-small ${classes.side}`}>
          Fixed <span className="dim">{length(fixedS)}</span>
        </p>
        <div style={{ marginLeft: share(headS, before.durationS), width: share(fixedS, before.durationS) }}>
          <Waveform
            label={`${before.name}, fixed`}
            peaks={fixedPeaks}
            durationS={fixedS}
            limitDbfs={limitDbfs}
            clock={clock('fixed')}
            playheadS={0}
            onSeek={(s) => fixing.hear('fixed', s)}
            heightPx={76}
            still={fixing.side !== 'fixed'}
            highlighted
            plain
          />
        </div>
      </div>
      <Spots name={before.name} spots={fix.spots} headS={headS} limitDbfs={limitDbfs} fixing={fixing} />
    </div>
  )
}

interface SpotsProps {
  name: string
  spots: readonly Spot[]
  headS: number
  limitDbfs?: number
  fixing: Fixing
}

const peaksOf = (shape: Shape) => finePeaks({ ...shape, points: shape.rms.length })
const SPOT_WORDS = { head: 'Start', tail: 'End', gain: 'Loudest part', offset: 'Offset' } as const

/** The sound around each repair, before and fixed, large enough to see what changes. */
function Spots({ name, spots, headS, limitDbfs, fixing }: SpotsProps) {
  const [kind, setKind] = useState<Spot['kind'] | null>(null)
  const spot = spots.find((candidate) => candidate.kind === kind) ?? spots.at(-1)
  if (spot === undefined) return null
  const wholeS = spot.end_s - spot.start_s
  const limit = spot.kind === 'gain' ? limitDbfs : undefined
  const cuts = [
    { startS: 0, endS: spot.after_start_s - spot.start_s },
    { startS: spot.after_end_s - spot.start_s, endS: wholeS },
  ].filter(({ startS, endS }) => endS - startS > 1e-6)
  const leftS = spot.after_end_s - spot.after_start_s
  return (
    <section className={`border-t mt-6px ${classes.spots}`} aria-label="Position">
      <div className={`flex wrap items-center between ${classes.spotHead}`}>
        <span className="small mid">{spotName(spot)}</span>
        {spots.length > 1 && (
          <Segmented
            label="Choose position"
            options={spots.map((option) => ({ value: option.kind, label: SPOT_WORDS[option.kind] }))}
            value={spot.kind}
            onChange={setKind}
          />
        )}
      </div>
      <div className={`grid grid-cols-2 gap-10px ${classes.pair}`}>
        <div>
          <Waveform
            label={`${name}, original, ${spotName(spot).toLowerCase()}`}
            peaks={peaksOf(spot.before)}
            durationS={wholeS}
            cuts={cuts}
            limitDbfs={limit}
            onSeek={(s) => fixing.hear('before', spot.start_s + s)}
            heightPx={92}
            still
            plain
          />
          <p className="micro dim">Original</p>
        </div>
        <div>
          {leftS > 0 && (
            <div style={{ marginLeft: share(spot.after_start_s - spot.start_s, wholeS), width: share(leftS, wholeS) }}>
              <Waveform
                label={`${name}, fixed, ${spotName(spot).toLowerCase()}`}
                peaks={peaksOf(spot.after)}
                durationS={leftS}
                limitDbfs={limit}
                onSeek={(s) => fixing.hear('fixed', spot.after_start_s - headS + s)}
                heightPx={92}
                still
                highlighted
                plain
              />
            </div>
          )}
          <p className="micro dim">Fixed</p>
        </div>
      </div>
    </section>
  )
}
