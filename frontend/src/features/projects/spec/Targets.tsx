import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { rate } from '@/ui/format'

import { sentence } from '../words'
import { Against, Choice, useWriting } from './fields'
import { targetInWords } from './say'
import classes from './SpecForm.module.css'
import { put, rename, type Tables, tableIn } from './tables'
import { isAt } from './trouble'

const RATES = [22050, 24000, 32000, 44100, 48000, 96000]
const DEPTHS: Record<string, { label: string; bit_depth: number; encoding: 'pcm' | 'float' }> = {
  pcm8: { label: '8 bit', bit_depth: 8, encoding: 'pcm' },
  pcm16: { label: '16 bit', bit_depth: 16, encoding: 'pcm' },
  pcm24: { label: '24 bit', bit_depth: 24, encoding: 'pcm' },
  float32: { label: '32 bit float', bit_depth: 32, encoding: 'float' },
}
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
      for (const [category, said] of Object.entries(tableIn(whole.categories))) {
        const own = tableIn(said).targets
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
  const encoding = target.encoding === 'float' ? 'float' : 'pcm'
  const depthKey = Object.keys(DEPTHS).find(
    (key) => DEPTHS[key]?.bit_depth === bits && DEPTHS[key].encoding === encoding,
  )
  const depths = Object.entries(DEPTHS).map(([value, { label }]) => ({ value, label }))
  const count = typeof target.channels === 'number' ? target.channels : 'master'
  const said = (key: string, usual: string) => (typeof target[key] === 'string' ? target[key] : usual)
  const clash = typed !== name && taken.includes(typed)
  const commit = () => {
    if (typed.trim() === '' || clash) setTyped(name)
    else if (typed !== name) onRename(typed.trim())
  }
  const facts = targetInWords({ sample_rate_hz: hz, bit_depth: bits, encoding, channels: count })
  return (
    <fieldset className={classes.target} data-wrong={isAt(trouble, place) || undefined}>
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
        options={[...new Set([...RATES, hz])].map((one) => ({ value: String(one), label: rate(one) }))}
        onChange={(value) => set([...place, 'sample_rate_hz'], Number(value))}
      />
      <Choice
        label="Bit depth"
        value={depthKey ?? 'other'}
        options={depthKey ? depths : [...depths, { value: 'other', label: `${bits} bit ${encoding}` }]}
        onChange={(value) => {
          const chosen = DEPTHS[value]
          if (chosen) set(place, { ...target, bit_depth: chosen.bit_depth, encoding: chosen.encoding })
        }}
      />
      <Choice
        label="Channels"
        value={String(count)}
        options={CHANNELS}
        onChange={(value) => set([...place, 'channels'], value === 'master' ? 'master' : Number(value))}
      />
      <Choice
        label="Dither"
        value={said('dither', 'tpdf')}
        options={DITHERS}
        onChange={(value) => set([...place, 'dither'], value)}
      />
      <Choice
        label="When it would clip"
        value={said('over_peak', 'attenuate')}
        options={OVER_PEAK}
        onChange={(value) => set([...place, 'over_peak'], value)}
      />
      <Button variant="quiet" square icon="cross" aria-label={`Remove ${name}`} onClick={onRemove} />
      {trouble && trouble.place !== place.join('.') && (
        <div className={classes.whole}>
          <Against place={place} />
        </div>
      )}
    </fieldset>
  )
}
