import { type ReactNode, useCallback, useEffect, useMemo, useRef, useState } from 'react'

import { figure } from '@/ui/format'

import { type Clock, useAt } from './clock'
import { Drawing } from './Drawing'
import { drawLevels, inkOf, LEVEL_FLOOR_DB, rgbOf, type Spectrogram, type Surface } from './draw'
import { levelsOf, type Peaks } from './peaks'
import classes from './Strip.module.css'

interface StripProps {
  durationS: number
  playheadS?: number
  clock?: Clock
  heightPx?: number
}

function Strip({
  name,
  durationS,
  playheadS,
  clock,
  heightPx,
  children,
}: StripProps & { name: string; children: ReactNode }) {
  const ref = useRef<HTMLDivElement>(null)
  useAt(ref, durationS, playheadS, clock)
  return (
    <div
      ref={ref}
      className={`bg-well flex-none overflow-hidden relative border rounded ${classes.strip}`}
      style={{ height: heightPx }}
    >
      {children}
      <span className={`absolute bottom-0 ${classes.playhead}`} />
      <span className={`mid ${classes.name}`}>{name}</span>
    </div>
  )
}

function Figure({ share, children }: { share: number; children: string }) {
  const edge = share < 0.12 ? { top: 4 } : share > 0.88 ? { bottom: 4 } : { top: `calc(${share * 100}% - 7px)` }
  return (
    <span className={`dim ${classes.figure}`} style={edge} aria-hidden="true">
      {children}
    </span>
  )
}

interface SpectrumStripProps extends StripProps {
  /** Values of the server, or the address of its grey picture; null while there is none. */
  spectrogram: Spectrogram | { src: string } | null
  fromHz?: number
  toHz?: number
}

/** What frequencies sound when: ink only, on the axis of the wave, with frequency on a logarithmic scale. */
export function SpectrumStrip({
  spectrogram,
  fromHz = 60,
  toHz = 20_000,
  heightPx = 132,
  ...axis
}: SpectrumStripProps) {
  const values = useValues(spectrogram)
  const draw = useCallback(
    (surface: Surface) => {
      if (values === null) return
      const { context, width, height, colour } = surface
      const own = new OffscreenCanvas(values.columns, values.rows)
      const pixels = inkOf(values, rgbOf(colour('spec-0')), rgbOf(colour('spec-1')))
      own.getContext('2d')?.putImageData(new ImageData(pixels, values.columns, values.rows), 0, 0)
      context.imageSmoothingQuality = 'high'
      context.drawImage(own, 0, 0, width, height)
    },
    [values],
  )
  const share = (hz: number) => 1 - Math.log(hz / fromHz) / Math.log(toHz / fromHz)
  return (
    <Strip name="Spectrum" heightPx={heightPx} {...axis}>
      <Drawing draw={draw} />
      <Figure share={0}>{toHz >= 1000 ? `${figure(toHz / 1000)}k` : figure(toHz)}</Figure>
      {fromHz < 2000 && toHz > 2000 && <Figure share={share(2000)}>2k</Figure>}
      <Figure share={1}>{`${figure(fromHz)} Hz`}</Figure>
    </Strip>
  )
}

/** A grey picture is read into values, so that it wears the theme's ink. */
function useValues(given: SpectrumStripProps['spectrogram']): Spectrogram | null {
  const src = given && 'src' in given ? given.src : null
  const [read, setRead] = useState<{ src: string; values: Spectrogram } | null>(null)
  useEffect(() => {
    if (src === null) return
    let isCurrent = true
    const picture = new Image()
    picture.onload = () => {
      const canvas = new OffscreenCanvas(picture.naturalWidth, picture.naturalHeight)
      const context = canvas.getContext('2d')
      if (!isCurrent || context === null) return
      context.drawImage(picture, 0, 0)
      const { data } = context.getImageData(0, 0, canvas.width, canvas.height)
      const values = new Uint8Array(canvas.width * canvas.height)
      for (let cell = 0; cell < values.length; cell += 1) values[cell] = data[cell * 4] ?? 0
      setRead({ src, values: { columns: canvas.width, rows: canvas.height, values } })
    }
    picture.src = src
    return () => {
      isCurrent = false
    }
  }, [src])
  if (given === null) return null
  if ('src' in given) return read?.src === given.src ? read.values : null
  return given
}

interface LevelStripProps extends StripProps {
  peaks: Peaks | null | undefined
  windowMs?: number
}

/** How loud it is when, from the same peaks as the wave. */
export function LevelStrip({ peaks, windowMs = 20, heightPx = 58, ...axis }: LevelStripProps) {
  const levels = useMemo(
    () => (peaks ? levelsOf(peaks, axis.durationS, windowMs / 1000) : new Float32Array(0)),
    [peaks, axis.durationS, windowMs],
  )
  const draw = useCallback((surface: Surface) => drawLevels(surface, levels), [levels])
  return (
    <Strip name={`Level, ${windowMs} ms`} heightPx={heightPx} {...axis}>
      <Drawing draw={draw} />
      {[-12, -36].map((db) => (
        <Figure key={db} share={db / LEVEL_FLOOR_DB}>
          {figure(db)}
        </Figure>
      ))}
    </Strip>
  )
}
