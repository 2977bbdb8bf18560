import { TextInput } from '@mantine/core'
import { useState } from 'react'

import { Card, CardHead } from '@/ui/Card'
import { Icon } from '@/ui/Icon'

import type { Cue } from '../api'
import { Categories } from './Categories'
import { tuningLimits, useChecks } from './checks'
import { Choices, NumberField, useWriting } from './fields'
import { AcceptFields, CheckFields, LimitFields } from './GroupFields'
import { fits } from './naming'
import { namesInWords } from './say'
import classes from './SpecForm.module.css'
import { at } from './tables'
import { Targets } from './Targets'

const ENGINE = ['reverb', 'occlusion', 'pitch', 'doppler'].map((value) => ({ value, label: value }))

/** The spec as fields, each at the place that its TOML names. */
export function SpecForm({ cues }: { cues: readonly Cue[] }) {
  const checks = useChecks()
  return (
    <div className="stack">
      <Card aria-labelledby="form-accept">
        <CardHead id="form-accept" title="Accepted masters" />
        <div className={`${classes.inside} items-start ${classes.two}`}>
          <AcceptFields base={[]} />
        </div>
      </Card>
      <Card aria-labelledby="form-limits">
        <CardHead id="form-limits" title="Limits" note="leave a field empty for no limit" />
        <div className={classes.inside}>
          <LimitFields base={[]} />
          <div className={`items-start ${classes.two} border-t mt-4 pt-3`}>
            {tuningLimits(checks).map(({ key, label, unit, usual }) => (
              <NumberField key={key} place={['limits', key]} label={label} unit={unit} usual={usual ?? undefined} />
            ))}
          </div>
        </div>
      </Card>
      <Card aria-labelledby="form-checks">
        <CardHead
          id="form-checks"
          title="Other checks"
          note="returns: the version is sent back; warns: it goes to review with a note"
        />
        <div className={classes.inside}>
          <CheckFields />
        </div>
      </Card>
      <Naming cues={cues} />
      <Card aria-labelledby="form-engine">
        <CardHead id="form-engine" title="Applied in engine" note="deliver dry, without these effects" />
        <div className={classes.inside}>
          <EngineFields />
        </div>
      </Card>
      <Targets />
      <Categories cues={cues} />
    </div>
  )
}

export const EngineFields = () => (
  <Choices place={['engine', 'adds']} label="Effects the engine adds" options={ENGINE} mayBeAny={false} />
)

function Naming({ cues }: { cues: readonly Cue[] }) {
  return (
    <Card aria-labelledby="form-naming">
      <CardHead id="form-naming" title="File names" />
      <div className={classes.inside}>
        <NamingFields cues={cues} />
      </div>
    </Card>
  )
}

/** The pattern of names, tried on the list's own names and on any other. */
export function NamingFields({ cues }: { cues: readonly Cue[] }) {
  const { tables, set, trouble } = useWriting()
  const saved = at(tables, ['naming', 'pattern'])
  const ending = at(tables, ['naming', 'extension'])
  const pattern = typeof saved === 'string' ? saved : ''
  const extension = typeof ending === 'string' ? ending : ''
  const [tried, setTried] = useState('')
  const stems = cues.flatMap((cue) => cue.stems)
  const odd = stems.filter((stem) => fits(pattern, stem) === false)
  const fit = tried === '' ? null : fits(pattern, tried)
  const error = (place: string) => (trouble?.place === place ? trouble.message : undefined)
  return (
    <div className={`items-start ${classes.two}`}>
      <TextInput
        id="spec-naming.pattern"
        classNames={{ input: classes.code }}
        label="Pattern (regular expression) without the extension"
        value={pattern}
        placeholder="any name"
        spellCheck={false}
        error={error('naming.pattern')}
        onChange={({ currentTarget: { value } }) => set(['naming', 'pattern'], value === '' ? undefined : value)}
      />
      <TextInput
        id="spec-naming.extension"
        classNames={{ input: classes.code }}
        label="Extension"
        value={extension}
        placeholder="any"
        spellCheck={false}
        error={error('naming.extension')}
        onChange={({ currentTarget: { value } }) => set(['naming', 'extension'], value === '' ? undefined : value)}
      />
      <TextInput
        classNames={{ input: classes.code }}
        label="Test a name"
        value={tried}
        placeholder={stems[0] ?? 'laser_fire_01'}
        spellCheck={false}
        onChange={({ currentTarget }) => setTried(currentTarget.value)}
      />
      <div className={`grid gap-1 ${classes.tried}`} role="status">
        {tried !== '' && (
          <p className={`row ${fit === false ? 'tone-bad' : 'tone-ok'}`}>
            {fit !== null && <Icon name={fit ? 'tick' : 'back'} />}
            <span>
              <span className="mono">{tried + extension}</span>{' '}
              {fit === null
                ? 'cannot be tested here; the pattern is validated when saved.'
                : fit
                  ? 'fits.'
                  : 'does not match.'}
            </span>
          </p>
        )}
        {stems.length > 0 && <p className="small mid">{namesInWords(odd, stems.length)}</p>}
      </div>
    </div>
  )
}
