import { useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { type Player, type PlayerState, WaveThumb } from '@/audio'
import { capital } from '@/verdicts/words'
import { Button } from '@/ui/Button'
import { channels, length, rate } from '@/ui/format'
import { Key } from '@/ui/Key'

import { type Guess, type Take, type TakeSounds, useSounds } from './api'
import { hear } from './ReturnedTakesCard'
import { CueField, VariationField } from './CueField'
import { baseOf, slotName } from './tray'
import classes from './Unmatched.module.css'

interface FileProps {
  projectId: string
  take: Take
  /** The keys belong to it. */
  current: boolean
  chosen: boolean
  player: Player
  playing: PlayerState
  busy: boolean
  onToggle: (ranged: boolean) => void
  onMove: (cue: { id: string; name: string }, variation: number | null) => void
  onDiscard: () => void
  onLater: () => void
}

function factsOf(sounds: TakeSounds | undefined): string {
  const facts = sounds?.master.facts ?? {}
  const seconds = sounds?.master.duration_s
  const said = [
    typeof seconds === 'number' ? length(seconds) : '',
    typeof facts.channels === 'number' ? channels(facts.channels) : '',
    typeof facts.sample_rate_hz === 'number' ? rate(facts.sample_rate_hz) : '',
  ].filter(Boolean)
  return said.length > 0 ? `${said.join(', ')}. ` : ''
}

const cueOf = ({ cue_id, name }: Guess) => ({ id: cue_id, name })

/** One file of the tray: what it sounds like, and which cue it is for or may be for. */
export function UnmatchedFile(props: FileProps) {
  const { take, current, chosen, player, playing, busy, onToggle } = props
  const { data: sounds } = useSounds(take)
  const url = sounds?.master.preview_url ?? null
  const sounding = playing.sourceId === take.id && playing.status === 'playing'
  const name = baseOf(take)
  return (
    <article
      id={`tray-${take.id}`}
      aria-label={take.file_name}
      className={`grid border-t ${classes.file}`}
      aria-busy={busy}
      aria-current={current || undefined}
      data-chosen={chosen || undefined}
    >
      <div>
        <label className={`flex items-start gap-2 min-w-0 pointer ${classes.tick}`}>
          <input
            type="checkbox"
            checked={chosen}
            aria-label={`Select ${take.file_name}`}
            onClick={(event) => {
              event.preventDefault()
              onToggle(event.shiftKey)
            }}
            readOnly
          />
          <span className="mono wrap-anywhere">{name}</span>
        </label>
        <div className="row">
          <span className="grow">
            <WaveThumb peaks={sounds?.master.thumb ?? null} heightPx={26} />
          </span>
          {url !== null && (
            <Button
              square
              variant="quiet"
              icon={sounding ? 'pause' : 'play'}
              aria-label={`${sounding ? 'Pause' : 'Play'} ${take.file_name}`}
              onClick={() => (sounding ? player.pause() : hear(player, take.id, url))}
            />
          )}
        </div>
      </div>
      <Choices {...props} facts={factsOf(sounds)} />
    </article>
  )
}

function Choices({ projectId, take, current, busy, facts, onMove, onDiscard, onLater }: FileProps & { facts: string }) {
  const [searching, setSearching] = useState(false)
  const [asking, setAsking] = useState<Guess | null>(null)
  const guesses = take.sure ? [take.sure] : take.guesses.slice(0, 3)
  const pick = (guess: Guess) =>
    guess.variations > 1 && guess.variation === null ? setAsking(guess) : onMove(cueOf(guess), guess.variation)

  useHotkeys([
    ...guesses.map((guess, index) => ({
      keys: String(index + 1),
      label: `The file is for ${slotName(guess)}`,
      group: 'Tray',
      disabled: !current || busy,
      run: () => pick(guess),
    })),
    { keys: '/', label: 'Other cue for the file', group: 'Tray', disabled: !current, run: () => setSearching(true) },
  ])
  if (searching) {
    return (
      <CueField
        projectId={projectId}
        label={`Cue for ${take.file_name}`}
        one
        onBack={() => setSearching(false)}
        onPick={onMove}
      />
    )
  }
  if (asking !== null) {
    return (
      <VariationField
        name={asking.name}
        variations={asking.variations}
        onBack={() => setAsking(null)}
        onPick={(variation) => onMove(cueOf(asking), variation)}
      />
    )
  }
  return (
    <div>
      <p className={`small mid ${classes.asks}`}>
        {facts}
        {take.sure ? `Sure: will be named ${take.sure.becomes ?? slotName(take.sure)}.` : 'Which cue is it?'}
      </p>
      <div className={`grid gap-2 ${classes.guesses}`}>
        {guesses.map((guess, index) => (
          <button type="button" key={guess.cue_id} disabled={busy} onClick={() => pick(guess)}>
            <span className="row between">
              <span className={take.sure ? 'strong' : undefined}>{slotName(guess)}</span>
              {current && <Key keys={String(index + 1)} />}
            </span>
            <span className="small mid">
              {guess.variations > 1 && guess.variation === null
                ? `${capital(guess.reason)}; choose one of ${guess.variations}`
                : capital(guess.reason)}
            </span>
          </button>
        ))}
      </div>
      <div className={`row wrap ${classes.acts}`}>
        <Button variant="quiet" disabled={busy} keys={current ? '/' : undefined} onClick={() => setSearching(true)}>
          Other cue…
        </Button>
        <Button variant="quiet" onClick={onLater}>
          Skip for now
        </Button>
        <Button variant="quiet" disabled={busy} onClick={onDiscard}>
          Discard
        </Button>
      </div>
    </div>
  )
}
