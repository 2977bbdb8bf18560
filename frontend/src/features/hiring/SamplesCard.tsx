import { useRef, useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Finding } from '@/ui/Finding'
import { Refusal } from '@/ui/Refusal'
import { bytes } from '@/ui/format'
import { Select } from '@/ui/Select'

import { type Posting, useAddSample, useRemoveSample } from './api'
import classes from './Hiring.module.css'
import { SampleLine } from './SampleLine'
import { useSamplePlayer } from './player'
import { base64Of, MAX_SAMPLE_BYTES } from './samples'

/** The sounds that a designer sends with a bid, each with what the check found. */
export function SamplesCard({ posting }: { posting: Posting }) {
  const { own_bid: own, lines, takes_bids: isTaking } = posting
  const [line, setLine] = useState(lines[0]?.key ?? '')
  const [tooLarge, setTooLarge] = useState<string | null>(null)
  const picker = useRef<HTMLInputElement>(null)
  const add = useAddSample(posting.id)
  const remove = useRemoveSample(posting.id)
  const player = useSamplePlayer()
  const samples = own?.samples ?? []
  const send = async (file: File | undefined) => {
    if (file === undefined) return
    setTooLarge(file.size > MAX_SAMPLE_BYTES ? file.name : null)
    if (file.size > MAX_SAMPLE_BYTES) return
    add.mutate({ line_key: line, file_name: file.name, content_base64: await base64Of(file) })
  }
  return (
    <Card aria-labelledby="samples">
      <CardHead id="samples" title="Samples" count={samples.length} />
      {lines.map(({ key, label }) => {
        const ofLine = samples.filter((sample) => sample.line_key === key)
        if (ofLine.length === 0) return null
        return (
          <section key={key} className={`grid gap-3 ${classes.body}`} aria-label={`Samples for ${label}`}>
            <h3>{label}</h3>
            {ofLine.map((sample) => (
              <div key={sample.id}>
                <SampleLine sample={sample} {...player} onToggle={player.toggle}>
                  {isTaking && (
                    <Button
                      square
                      variant="quiet"
                      icon="cross"
                      aria-label={`Remove ${sample.file_name}`}
                      onClick={() => remove.mutate(sample.id)}
                    />
                  )}
                </SampleLine>
                {sample.findings.map(({ code, severity, message, fix }) => (
                  <Finding key={code} severity={severity === 'error' ? 'error' : 'warning'} head={message}>
                    {fix}
                  </Finding>
                ))}
              </div>
            ))}
          </section>
        )
      })}
      <div className={`grid gap-3 ${classes.body}`}>
        {own === null ? (
          <p className="mid">Save a draft of your bid to add sounds to it.</p>
        ) : (
          isTaking && (
            <div className="row wrap">
              <Select label="For" value={line} onChange={({ currentTarget }) => setLine(currentTarget.value)}>
                {lines.map(({ key, label }) => (
                  <option key={key} value={key}>
                    {label}
                  </option>
                ))}
              </Select>
              <Button icon="upload" aria-busy={add.isPending} onClick={() => picker.current?.click()}>
                Add a sound
              </Button>
            </div>
          )
        )}
        {tooLarge !== null && (
          <p role="alert">{`${tooLarge} is larger than ${bytes(MAX_SAMPLE_BYTES)}. Send a shorter excerpt.`}</p>
        )}
        <Refusal error={add.error ?? remove.error} />
        <p className="small mid">
          Up to 8 sounds of 6 MB. Each is checked by the project’s delivery spec, and both sides see the result. The
          studio hears them once the bid is sent. They are never deliveries; 30 days after another bid is chosen they
          can no longer be played.
        </p>
      </div>
      <input
        ref={picker}
        type="file"
        hidden
        aria-label="A sound for the bid"
        accept="audio/*"
        onChange={(event) => {
          void send(event.currentTarget.files?.[0])
          event.currentTarget.value = ''
        }}
      />
    </Card>
  )
}
