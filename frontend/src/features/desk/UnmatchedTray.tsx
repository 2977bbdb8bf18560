import { Select } from '@mantine/core'
import { useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { showToast } from '@/app/toast'
import { type Player, type PlayerState, WaveThumb } from '@/audio'
import { capital } from '@/judging/words'
import { Button } from '@/ui/Button'
import { channels, length, rate } from '@/ui/format'
import { Key } from '@/ui/Key'
import { State } from '@/ui/State'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type Cue, type Guess, type Take, type TakeSounds, useCues, useMatch, useSounds } from './api'
import { hear } from './CameBackCard'
import { Refusal } from './Refusal'
import classes from './Unmatched.module.css'

interface TrayProps {
  projectId: string
  takes: readonly Take[]
  player: Player
  playing: PlayerState
}

/** Files that no cue owns by name: each with its likeliest cues, one press away. */
export function UnmatchedTray({ projectId, takes, player, playing }: TrayProps) {
  const [later, setLater] = useState<ReadonlySet<string>>(new Set())
  const match = useMatch(projectId)
  const now = takes.filter(({ id }) => !later.has(id))
  const kept = takes.length - now.length

  const say = (take: Take, cueId: string, name: string, variation?: number) =>
    match.mutate(
      { take, cueId, variation },
      { onSuccess: () => showToast(`${take.file_name} is for ${name} and will be named for it.`) },
    )
  if (takes.length === 0) return null
  return (
    <section aria-label="Unmatched files">
      {match.error !== null && (
        <div className={classes.problem}>
          <Refusal error={match.error} about={match.variables?.take.file_name} />
        </div>
      )}
      {now.map((take, index) => (
        <UnmatchedFile
          key={take.id}
          projectId={projectId}
          take={take}
          first={index === 0}
          count={takes.length}
          player={player}
          playing={playing}
          busy={match.isPending && match.variables.take.id === take.id}
          onSay={(cueId, name, variation) => say(take, cueId, name, variation)}
          onLater={() => setLater(new Set([...later, take.id]))}
        />
      ))}
      {kept > 0 && (
        <div className={classes.kept}>
          <State kind="unmatched">{kept} kept for later</State>
          <button type="button" className="link small mid" onClick={() => setLater(new Set())}>
            Show {kept === 1 ? 'it' : 'them'}
          </button>
        </div>
      )}
    </section>
  )
}

interface FileProps extends Omit<TrayProps, 'takes'> {
  take: Take
  /** The keys belong to it. */
  first: boolean
  count: number
  busy: boolean
  onSay: (cueId: string, name: string, variation?: number) => void
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
  return said.length > 0 ? ` ${said.join(', ')}.` : ''
}

function UnmatchedFile({ projectId, take, first, count, player, playing, busy, onSay, onLater }: FileProps) {
  const { data: sounds } = useSounds(take.id)
  const [searching, setSearching] = useState(false)
  const guesses = take.guesses.slice(0, 3)
  const url = sounds?.master.preview_url ?? null
  const sounding = playing.sourceId === take.id && playing.status === 'playing'
  const pick = (guess: Guess) => onSay(guess.cue_id, guess.name, guess.variation)

  useHotkeys([
    ...guesses.map((guess, index) => ({
      keys: String(index + 1),
      label: `The file is for ${guess.name}`,
      group: 'Desk',
      disabled: !first || busy,
      run: () => pick(guess),
    })),
    { keys: '/', label: 'Another cue for the file', group: 'Desk', disabled: !first, run: () => setSearching(true) },
  ])
  return (
    <div className={classes.file} aria-busy={busy}>
      <div>
        {first && <State kind="unmatched">Unmatched, {count}</State>}
        <p className={`mono ${classes.name}`}>{take.file_name}</p>
        <div className={classes.wave}>
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
      <div>
        <p className={`small mid ${classes.asks}`}>Which cue is it?{factsOf(sounds)} It will be named for the cue.</p>
        {searching ? (
          <AnotherCue projectId={projectId} take={take} onSay={onSay} onBack={() => setSearching(false)} />
        ) : (
          <div className={classes.guesses}>
            {guesses.map((guess, index) => (
              <button type="button" key={guess.cue_id} disabled={busy} onClick={() => pick(guess)}>
                <span className={classes.guessHead}>
                  <span className={index === 0 ? 'strong' : undefined}>{guess.name}</span>
                  {first && <Key keys={String(index + 1)} />}
                </span>
                <span className="small mid">{capital(guess.reason)}</span>
              </button>
            ))}
            <button type="button" disabled={busy} onClick={() => setSearching(true)}>
              <span className={classes.guessHead}>
                Another
                {first && <Key keys="/" />}
              </span>
              <span className="small mid">search the list</span>
            </button>
            <button type="button" onClick={onLater}>
              <span className={classes.guessHead}>Later</span>
              <span className="small mid">it stays here</span>
            </button>
          </div>
        )}
      </div>
    </div>
  )
}

interface AnotherProps {
  projectId: string
  take: Take
  onSay: (cueId: string, name: string) => void
  onBack: () => void
}

const optionOf = ({ id, label, name, use }: Cue) => ({ value: id, label: `${label} ${name}${use ? `, ${use}` : ''}` })

function AnotherCue({ projectId, take, onSay, onBack }: AnotherProps) {
  const { data: cues } = useCues(projectId)
  const field = useFocusOnMount<HTMLInputElement>()
  return (
    <div className={classes.search}>
      <Select
        className="grow"
        aria-label={`Cue for ${take.file_name}`}
        placeholder="Number, name or use"
        searchable
        ref={field}
        data={cues?.map(optionOf) ?? []}
        limit={50}
        nothingFoundMessage="No cue matches."
        comboboxProps={{ transitionProps: { duration: 0 } }}
        onChange={(id) => {
          const cue = cues?.find((one) => one.id === id)
          if (cue) onSay(cue.id, cue.name)
        }}
        onKeyDown={(event) => {
          if (event.key === 'Escape') onBack()
        }}
      />
      <Button variant="quiet" onClick={onBack}>
        Back
      </Button>
    </div>
  )
}
