import { useState } from 'react'

import type { ReviewTake } from '@/verdicts/api'
import { sentence } from '@/verdicts/words'
import { LossPanel } from '@/losses'
import { Segmented } from '@/ui/Segmented'

import classes from './Side.module.css'

/** What each game file of a version lost against its master: one target at a time. */
export function GameFiles({ take: { renders } }: { take: ReviewTake }) {
  const [chosen, setChosen] = useState(renders[0]?.target ?? '')
  const file = renders.find(({ target }) => target === chosen)
  if (file === undefined) {
    return <p className={`${classes.quiet} mid`}>The delivery spec has no targets, so there are no game files.</p>
  }
  return (
    <section className={classes.block} aria-label={`Game file for ${file.target}`}>
      {renders.length > 1 && (
        <p className="mb-2">
          <Segmented
            label="Target"
            options={renders.map(({ target }) => ({ value: target, label: target }))}
            value={chosen}
            onChange={setChosen}
          />
        </p>
      )}
      {file.state === 'made' && file.id && <LossPanel key={file.id} renderId={file.id} target={file.target} />}
      {file.state === 'waiting' && <p className="mid">Rendering…</p>}
      {file.state === 'refused' && <p className="mid">{sentence(file.refusal ?? 'Refused.')}</p>}
    </section>
  )
}
