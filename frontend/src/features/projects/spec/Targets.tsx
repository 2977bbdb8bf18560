import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { rate } from '@/ui/format'
import { sentence } from '@/ui/sentence'

import { Against, Choice, NumberField, useWriting } from './fields'
import { targetInWords } from './say'
import classes from './SpecForm.module.css'
import { put, rename, type Tables, tableIn } from './tables'
import { isAt } from './trouble'

const RATES = [22050, 24000, 32000, 44100, 48000, 96000]
interface Format {
  label: string
  encoding: string
  /** None where a lossy codec keeps the sound: it has a quality instead. */
  bit_depth?: number
  /** The only rate there is. */
  sample_rate_hz?: number
}
const FORMATS: Record<string, Format> = {
  pcm8: { label: '8 bit', bit_depth: 8, encoding: 'pcm' },
  pcm16: { label: '16 bit', bit_depth: 16, encoding: 'pcm' },
  pcm24: { label: '24 bit', bit_depth: 24, encoding: 'pcm' },
  float32: { label: '32 bit float', bit_depth: 32, encoding: 'float' },
  flac16: { label: '16-bit FLAC', bit_depth: 16, encoding: 'flac' },
  flac24: { label: '24-bit FLAC', bit_depth: 24, encoding: 'flac' },
  vorbis: { label: 'Ogg Vorbis', encoding: 'vorbis' },
  opus: { label: 'Opus', encoding: 'opus', sample_rate_hz: 48000 },
}
const USUAL_QUALITY = 0.5
const CHANNELS = [
  { value: 'master', label: 'same as master' },
  { value: '1', label: 'mono' },
  { value: '2', label: 'stereo' },
]
const DITHERS = [
  { value: 'tpdf', label: 'TPDF' },
  { value: 'shaped', label: 'shaped' },
  { value: 'none', label: 'none' },
]
const OVER_PEAK = [
  { value: 'attenuate', label: 'attenuate' },
  { value: 'refuse', label: 'refuse' },
]

/** A name that is free: target, target_2 … */
function freeName(taken: Tables): string {
  let name = 'target'
  for (let count = 2; name in taken; count += 1) name = `target_${count}`
  return name
}

/** What is made from each master. */
export function Targets() {
  const { tables, set, change } = useWriting()
  const targets = tableIn(tables.targets)
  const names = Object.keys(targets)
  const add = () => set(['targets', freeName(targets)], { sample_rate_hz: 48000, bit_depth: 16 })
  // Overrides of categories refer to the target by its name.
  const everywhere = (apply: (own: Tables) => Tables) =>
    change((whole) => {
      let next = put(whole, ['targets'], apply(tableIn(whole.targets)))
      for (const [category, table] of Object.entries(tableIn(whole.categories))) {
        const own = tableIn(table).targets
        if (own === undefined) continue
        const left = apply(tableIn(own))
        const place = ['categories', category, 'targets']
        next = put(next, place, Object.keys(left).length > 0 ? left : undefined, true)
      }
      return next
    })
  return (
    <Card aria-labelledby="form-targets">
      <CardHead
        id="form-targets"
        title="Game files"
        note="rendered from each accepted master"
        end={
          <Button icon="plus" onClick={add}>
            Add target
          </Button>
        }
      />
      {names.length === 0 && (
        <div className={classes.inside}>
          <EmptyState head="No targets" level={3}>
            A target sets the sample rate and bit depth of the game’s files.
          </EmptyState>
        </div>
      )}
      {names.map((name, index) => (
        <Target
          key={index}
          name={name}
          taken={names}
          onRename={(next) => everywhere((own) => rename(own, name, next))}
          onRemove={() => everywhere((own) => put(own, [name], undefined))}
        />
      ))}
    </Card>
  )
}

interface TargetProps {
  name: string
  taken: readonly string[]
  onRename: (name: string) => void
  onRemove: () => void
}

function Target({ name, taken, onRename, onRemove }: TargetProps) {
  const { tables, set, trouble } = useWriting()
  const place = ['targets', name]
  const target = tableIn(tableIn(tables.targets)[name])
  const [typed, setTyped] = useState(name)
  const hz = typeof target.sample_rate_hz === 'number' ? target.sample_rate_hz : 48000
  const bits = typeof target.bit_depth === 'number' ? target.bit_depth : 16
  const encoding = typeof target.encoding === 'string' ? target.encoding : 'pcm'
  const formatKey = Object.keys(FORMATS).find((key) => {
    const format = FORMATS[key]
    return format?.encoding === encoding && (format.bit_depth === undefined || format.bit_depth === bits)
  })
  const format = formatKey === undefined ? undefined : FORMATS[formatKey]
  const isLossy = format !== undefined && format.bit_depth === undefined
  const quality = typeof target.quality === 'number' ? target.quality : USUAL_QUALITY
  const formats = Object.entries(FORMATS).map(([value, { label }]) => ({ value, label }))
  const rates = format?.sample_rate_hz === undefined ? RATES : [format.sample_rate_hz]
  const count = typeof target.channels === 'number' ? target.channels : 'master'
  const textAt = (key: string, usual: string) => (typeof target[key] === 'string' ? target[key] : usual)
  const clash = typed !== name && taken.includes(typed)
  const commit = () => {
    if (typed.trim() === '' || clash) setTyped(name)
    else if (typed !== name) onRename(typed.trim())
  }
  const facts = targetInWords({
    sample_rate_hz: hz,
    bit_depth: bits,
    encoding,
    quality: isLossy ? quality : null,
    channels: count,
  })
  const keepAs = (chosen: Format) => {
    const lossy = chosen.bit_depth === undefined
    const next = {
      ...target,
      encoding: chosen.encoding,
      bit_depth: chosen.bit_depth,
      sample_rate_hz: chosen.sample_rate_hz ?? hz,
      quality: lossy ? target.quality : undefined,
      dither: lossy ? undefined : target.dither,
    }
    set(place, Object.fromEntries(Object.entries(next).filter(([, value]) => value !== undefined)))
  }
  return (
    <fieldset className={`grid items-end gap-2-3 ${classes.target}`} data-wrong={isAt(trouble, place) || undefined}>
      <legend className="visually-hidden">{`Target ${name}: ${facts}`}</legend>
      <TextInput
        id={`spec-targets.${name}`}
        label="Name"
        value={typed}
        spellCheck={false}
        onChange={({ currentTarget }) => setTyped(currentTarget.value)}
        onBlur={commit}
        error={
          clash
            ? 'Another target has this name.'
            : trouble?.place === place.join('.')
              ? sentence(trouble.message)
              : undefined
        }
      />
      <Choice
        label="Sample rate"
        value={String(hz)}
        options={[...new Set([...rates, hz])].map((rateHz) => ({ value: String(rateHz), label: rate(rateHz) }))}
        onChange={(value) => set([...place, 'sample_rate_hz'], Number(value))}
      />
      <Choice
        label="Format"
        value={formatKey ?? 'other'}
        options={formatKey ? formats : [...formats, { value: 'other', label: `${bits} bit ${encoding}` }]}
        onChange={(value) => {
          const chosen = FORMATS[value]
          if (chosen) keepAs(chosen)
        }}
      />
      <Choice
        label="Channels"
        value={String(count)}
        options={CHANNELS}
        onChange={(value) => set([...place, 'channels'], value === 'master' ? 'master' : Number(value))}
      />
      {isLossy ? (
        <NumberField place={[...place, 'quality']} label="Quality" unit="0 to 1" usual={USUAL_QUALITY} />
      ) : (
        <Choice
          label="Dither"
          value={textAt('dither', 'tpdf')}
          options={DITHERS}
          onChange={(value) => set([...place, 'dither'], value)}
        />
      )}
      <Choice
        label="When it would clip"
        value={textAt('over_peak', 'attenuate')}
        options={OVER_PEAK}
        onChange={(value) => set([...place, 'over_peak'], value)}
      />
      <Button variant="quiet" square icon="cross" aria-label={`Remove ${name}`} onClick={onRemove} />
      {trouble && trouble.place !== place.join('.') && (
        <div className="col-span-full">
          <Against place={place} />
        </div>
      )}
    </fieldset>
  )
}
