import { type CSSProperties, useCallback, useLayoutEffect, useMemo, useRef, useState } from 'react'

import { figure, place, placeInWords, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { SEVERITY_LOOK, type Severity } from '@/ui/severity'

import { gridStepS, type Layout, stack, ticksOf } from './axis'
import { type Clock, useAt } from './clock'
import { Drawing } from './Drawing'
import { drawAxis, drawCuts, drawGrid, drawLimit, drawWave, type Surface, type TimeRange } from './draw'
import { amplitudeOf, type Peaks } from './peaks'
import { Slider } from './Slider'
import classes from './Waveform.module.css'

/** A finding on the wave: a label above it, and its range or its point inside. */
export interface FindingMark {
  id: string
  severity: Severity
  label: string
  /** After the label, quietly; left out on narrow screens. */
  more?: string
  startS?: number
  endS?: number
}

/** A comment on the wave: a pin for a point, a bar for a range. */
export interface CommentMark {
  id: string
  number: number
  startS: number
  endS?: number
}

export interface WaveformProps {
  /** What sounds: "shield_hit, A". */
  label: string
  /** undefined while it is on its way; null while the server still draws it. */
  peaks: Peaks | null | undefined
  durationS: number
  findings?: readonly FindingMark[]
  comments?: readonly CommentMark[]
  /** The comment that is open in the list. */
  openComment?: string
  playheadS?: number
  /** Follows a player; then `playheadS` is not needed. */
  clock?: Clock
  onSeek?: (s: number) => void
  /** A marker was pressed: 0.3 s before it, and itself. */
  onMark?: (fromS: number, mark: FindingMark | CommentMark) => void
  selection?: TimeRange | null
  /** Dragging across the wave picks a range; a short press takes it away. */
  onSelect?: (range: TimeRange | null) => void
  limitDbfs?: number
  /** What a fix takes away. */
  cuts?: readonly TimeRange[]
  /** All of it is highlighted, not only the played part. */
  highlighted?: boolean
  /** Height of the wave; without it, it fills its place. */
  heightPx?: number
  /** Without grid, ruler and figures, as in a card. */
  plain?: boolean
  /** Without a playhead: what sounds is shown elsewhere. */
  still?: boolean
}

const PAD_PX = 8
const LEAD_IN_S = 0.3
const PIN_PX = 24

/** Where playing from a marker starts. */
export const spotOf = (startS: number): number => Math.max(0, startS - LEAD_IN_S)

/** Letters of 12 px are at most this wide in the widest fall-back font. */
const LETTER_PX = 7
const labelPx = ({ label, more }: FindingMark, narrow: boolean): number =>
  30 + (label.length + (more && !narrow ? more.length + 1 : 0)) * LETTER_PX

function useWidth(): [React.RefObject<HTMLDivElement | null>, number] {
  const ref = useRef<HTMLDivElement>(null)
  const [width, setWidth] = useState(0)
  useLayoutEffect(() => {
    const element = ref.current
    if (element === null) return
    const measure = () => setWidth(element.clientWidth)
    measure()
    const observer = new ResizeObserver(measure)
    observer.observe(element)
    return () => observer.disconnect()
  }, [])
  return [ref, width]
}

/** A sound with everything that was found and said about it, on one axis of time. */
export function Waveform(props: WaveformProps) {
  const { label, peaks, durationS, findings = [], comments = [], clock, playheadS, plain = false, heightPx } = props
  const [rootRef, width] = useWidth()
  const narrow = width > 0 && width < 560
  const stepS = gridStepS(durationS, width, narrow ? 60 : 84)
  useAt(rootRef, durationS, playheadS, clock)

  return (
    <div ref={rootRef} className={`min-w-0 ${classes.root}`} data-fill={heightPx === undefined || undefined}>
      {findings.length > 0 && (
        <FindingsLane findings={findings} durationS={durationS} width={width} narrow={narrow} onMark={props.onMark} />
      )}
      <div className={`bg-well overflow-hidden relative border rounded ${classes.well}`} style={{ height: heightPx }}>
        <Shape {...props} stepS={plain ? undefined : stepS} />
        {props.selection && <span className={classes.selection} style={spanStyle(props.selection, durationS)} />}
        {findings.map(
          (mark) =>
            mark.startS !== undefined && (
              <span
                key={mark.id}
                className={`absolute bottom-0 ${classes.flag} tone-${SEVERITY_LOOK[mark.severity].tone}`}
                style={spanStyle({ startS: mark.startS, endS: mark.endS ?? mark.startS }, durationS)}
              />
            ),
        )}
        {peaks === null && (
          <p className={classes.missing}>The waveform is being drawn. You can play the sound already.</p>
        )}
        {!plain && <Scale limitDbfs={props.limitDbfs} />}
        <Slider {...props} label={label} />
        {!props.still && <span className={`absolute bottom-0 ${classes.playhead}`} />}
        {comments.length > 0 && (
          <Pins
            comments={comments}
            open={props.openComment}
            durationS={durationS}
            width={width}
            onMark={props.onMark}
          />
        )}
      </div>
      {!plain && <Ruler durationS={durationS} stepS={stepS} width={width} />}
    </div>
  )
}

function spanStyle({ startS, endS }: TimeRange, durationS: number): CSSProperties {
  return { left: `${(startS / durationS) * 100}%`, width: `${((endS - startS) / durationS) * 100}%` }
}

function Shape({ peaks, durationS, limitDbfs, cuts, highlighted = false, stepS }: WaveformProps & { stepS?: number }) {
  const drawBase = useCallback(
    (surface: Surface) => {
      if (stepS !== undefined) drawGrid(surface, durationS, stepS, PAD_PX)
      if (cuts) drawCuts(surface, cuts, durationS)
      drawAxis(surface)
      if (peaks) drawWave(surface, peaks, { highlighted, limitDbfs, pad: PAD_PX })
      if (limitDbfs !== undefined) drawLimit(surface, limitDbfs, PAD_PX)
    },
    [peaks, durationS, stepS, cuts, limitDbfs, highlighted],
  )
  const drawPlayed = useCallback(
    (surface: Surface) => {
      if (peaks) drawWave(surface, peaks, { highlighted: true, limitDbfs, pad: PAD_PX })
    },
    [peaks, limitDbfs],
  )
  return (
    <>
      <Drawing draw={drawBase} />
      {!highlighted && <Drawing draw={drawPlayed} className={classes.played} />}
    </>
  )
}

function Scale({ limitDbfs }: { limitDbfs?: number }) {
  const lines = [...new Set([...(limitDbfs === undefined ? [] : [limitDbfs]), -6, -12])]
  return (
    <span aria-hidden="true">
      {lines.map((db) => (
        <span
          key={db}
          className={`wide-only absolute rounded-2px bg-well dim ${classes.scale}`}
          style={{ top: `calc(50% - (50% - ${PAD_PX}px) * ${amplitudeOf(db).toFixed(4)} - 7px)` }}
        >
          {figure(db, Number.isInteger(db) ? 0 : 1)}
        </span>
      ))}
    </span>
  )
}

function Ruler({ durationS, stepS, width }: { durationS: number; stepS: number; width: number }) {
  const ticks = ticksOf(durationS, stepS, width)
  return (
    <div className={`relative dim ${classes.ruler}`} aria-hidden="true">
      {ticks.map(({ atS, text }, index) => (
        <span
          key={text}
          data-edge={index === 0 ? 'start' : index === ticks.length - 1 ? 'end' : undefined}
          style={{ left: `${(atS / durationS) * 100}%` }}
        >
          {text}
        </span>
      ))}
    </div>
  )
}

interface LaneProps {
  durationS: number
  width: number
  onMark: WaveformProps['onMark']
}

function FindingsLane({
  findings,
  durationS,
  width,
  narrow,
  onMark,
}: LaneProps & { findings: readonly FindingMark[]; narrow: boolean }) {
  const [all, setAll] = useState(false)
  const layout = useMemo<Layout<FindingMark>>(
    () =>
      stack(
        findings,
        width,
        (mark) => ({
          leftPx: ((mark.startS ?? 0) / durationS) * width,
          widthPx: Math.min(width, labelPx(mark, narrow)),
        }),
        all ? findings.length : 3,
      ),
    [findings, width, durationS, narrow, all],
  )
  return (
    <div className="relative" style={{ height: Math.max(1, layout.lanes) * 26 }}>
      {layout.placed.map(({ item, leftPx, lane }) => (
        <button
          type="button"
          key={item.id}
          className={`inline-flex items-center absolute min-h-24px border-0 rounded-s text-small leading-small nowrap pointer ${classes.label} tone-${SEVERITY_LOOK[item.severity].tone}`}
          style={{ left: leftPx, top: lane * 26, maxWidth: width || undefined }}
          onClick={() => onMark?.(spotOf(item.startS ?? 0), item)}
        >
          <Icon name={SEVERITY_LOOK[item.severity].icon} size={14} />
          {item.label}
          {item.more && <span className={`wide-only dim ${classes.more}`}>{item.more}</span>}
          {item.startS !== undefined && <span className="visually-hidden">, at {placeInWords(item.startS)}</span>}
        </button>
      ))}
      {layout.moreAt && (
        <button
          type="button"
          className={`inline-flex items-center absolute min-h-24px border-0 rounded-s text-small leading-small nowrap pointer ${classes.label} ${classes.rest}`}
          style={{ left: layout.moreAt.leftPx, top: layout.moreAt.lane * 26 }}
          onClick={() => setAll(true)}
        >
          +{layout.hidden.length} <span className="visually-hidden">more findings</span>
        </button>
      )}
    </div>
  )
}

function Pins({
  comments,
  open,
  durationS,
  width,
  onMark,
}: LaneProps & { comments: readonly CommentMark[]; open?: string }) {
  const [all, setAll] = useState(false)
  const layout = useMemo<Layout<CommentMark>>(
    () =>
      stack(
        comments,
        width,
        ({ startS, endS }) => {
          const x = (startS / durationS) * width
          if (endS === undefined) return { leftPx: x - PIN_PX / 2, widthPx: PIN_PX }
          return { leftPx: x, widthPx: Math.max(PIN_PX, ((endS - startS) / durationS) * width) }
        },
        all ? comments.length : 3,
      ),
    [comments, durationS, width, all],
  )
  return (
    <>
      {layout.placed.map(({ item, leftPx, lane }) => (
        <button
          type="button"
          key={item.id}
          className={`grid pointer strong absolute p-0 bg-raised ink ${classes.pin}`}
          data-range={item.endS !== undefined || undefined}
          aria-pressed={item.id === open}
          aria-label={
            item.endS === undefined
              ? `Comment ${item.number} at ${placeInWords(item.startS)}`
              : `Comment ${item.number} from ${place(item.startS)} to ${placeInWords(item.endS)}`
          }
          style={{
            left: leftPx,
            bottom: 4 + lane * 27,
            width:
              item.endS === undefined ? undefined : Math.max(PIN_PX, ((item.endS - item.startS) / durationS) * width),
          }}
          onClick={() => onMark?.(spotOf(item.startS), item)}
        >
          {item.number}
        </button>
      ))}
      {layout.moreAt && (
        <button
          type="button"
          className={`grid pointer strong absolute p-0 bg-raised ink ${classes.pin}`}
          style={{ left: layout.moreAt.leftPx, bottom: 4 + layout.moreAt.lane * 27 }}
          aria-label={plural(layout.hidden.length, 'more comment')}
          onClick={() => setAll(true)}
        >
          +{layout.hidden.length}
        </button>
      )}
    </>
  )
}
