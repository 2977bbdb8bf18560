import { useEffect, useMemo, useRef } from 'react'

import { useDraft } from '@/app/drafts'
import { useHotkeys } from '@/app/keys'
import { type Peaks, Waveform } from '@/audio'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { usePeaks } from '@/verdicts/peaks'
import { Button } from '@/ui/Button'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'
import { StatusBadge } from '@/ui/StatusBadge'

import type { CueToHear, HeardAs } from './api'
import classes from './Listening.module.css'
import { louder } from './louder'
import type { ShownNote } from './useNotes'
import { SAID_WORDS, SAYINGS, signed, taskOf } from './words'

const GROUP = 'Listening pass'
const STEP_DB = 1
const FIRST_DB = 3
const MOST_DB = 24

interface Choice {
  said: HeardAs | null
  amountDb: number | null
  text: string
}
const NOTHING: Choice = { said: null, amountDb: null, text: '' }

interface SoundToJudgeProps {
  cue: CueToHear
  projectId: string
  passId: string
  buildLabel: string
  /** What I said of it before. */
  said: ShownNote | undefined
  next: string | undefined
  onSay: (heardAs: HeardAs, amountDb: number | null, text: string) => void
  onUndo: (() => void) | undefined
}

/** What a choice proposes as its gain: back to the approved level where the build moved it, else 3 dB. */
export function proposedDb(heardAs: HeardAs, suggestedDb: number | null): number | null {
  if (heardAs === 'too-loud') return suggestedDb !== null && suggestedDb < 0 ? suggestedDb : -FIRST_DB
  if (heardAs === 'too-soft') return suggestedDb !== null && suggestedDb > 0 ? suggestedDb : FIRST_DB
  return null
}

/** One cue: what the build makes of it, and what it is like. */
export function SoundToJudge(props: SoundToJudgeProps) {
  const { cue, projectId, passId, buildLabel, said, next, onSay, onUndo } = props
  const before: Choice = said ? { said: said.said, amountDb: said.amountDb, text: said.text } : NOTHING
  const [choice, setChoice, draft] = useDraft<Choice>(`listening:${passId}:${cue.cue.id}`, before)
  const head = useRef<HTMLHeadingElement>(null)
  useEffect(() => head.current?.focus({ preventScroll: true }), [])
  const choose = (heardAs: HeardAs) =>
    setChoice((now) => ({ ...now, said: heardAs, amountDb: proposedDb(heardAs, cue.suggested_db) }))
  const say = (heardAs: HeardAs | null) => {
    if (heardAs === null) return
    const { amountDb, text } = choice
    draft.discard()
    onSay(heardAs, heardAs === choice.said ? amountDb : null, text.trim())
  }
  useHotkeys([
    ...SAYINGS.map(({ said: heardAs, word, keys }) => ({
      keys,
      label: word,
      group: GROUP,
      run: () => choose(heardAs),
    })),
    { keys: '0', label: 'Not reached, next', group: GROUP, run: () => say('not-reached') },
    {
      keys: 'Enter',
      label: 'Save and next',
      group: GROUP,
      run: () => say(choice.said),
      disabled: choice.said === null,
    },
  ])
  return (
    <>
      <header>
        <div className="row wrap between">
          <h2 ref={head} tabIndex={-1} className="title">
            {cue.cue.name}
          </h2>
          {cue.gain_db !== null && Math.abs(cue.gain_db) >= 0.1 && (
            <StatusBadge kind="warning" pill>
              {`${signed(cue.gain_db)} against approved`}
            </StatusBadge>
          )}
        </div>
        <p className="mid">
          {[cue.description, cue.files > 1 ? `Set of ${cue.files}.` : ''].filter(Boolean).join(' ')}{' '}
          <span className="mono small">{cue.events.join(', ')}</span>
        </p>
        {cue.depends.length > 0 && <p className="small mid">{`Its level depends on ${cue.depends.join(', ')}.`}</p>}
      </header>
      {cue.sound?.preview_url && <Player cue={cue} projectId={projectId} buildLabel={buildLabel} />}
      <div className={`grid gap-2 ${classes.keys}`} role="group" aria-label="What is it like in the game?">
        {SAYINGS.map(({ said: heardAs, word, keys, icon }) => (
          <button
            key={heardAs}
            type="button"
            className={`flex items-center gap-3 hover bg-raised pointer rounded ${classes.bigKey}`}
            data-wide={heardAs === 'good' || undefined}
            aria-pressed={choice.said === heardAs}
            aria-keyshortcuts={keys}
            onClick={() => choose(heardAs)}
          >
            <Icon name={icon} />
            <span>{word}</span>
            <Key keys={keys} />
          </button>
        ))}
      </div>
      {(choice.said === 'too-loud' || choice.said === 'too-soft') && (
        <Amount cue={cue} choice={choice} onChange={(amountDb) => setChoice((now) => ({ ...now, amountDb }))} />
      )}
      <label className="block">
        <span className="visually-hidden">In words</span>
        <input
          className={`bg-raised w-full border-edge rounded ink font-inherit ${classes.text}`}
          value={choice.text}
          maxLength={1_000}
          placeholder="Comment (optional)"
          onChange={({ target }) => setChoice((now) => ({ ...now, text: target.value }))}
          onKeyDown={({ key, nativeEvent }) => {
            if (key === 'Enter' && !nativeEvent.isComposing) say(choice.said)
          }}
        />
      </label>
      <footer className={`row sticky bottom-0 bg-surface ${classes.verdict}`}>
        <div className={`flex-1 min-w-0 ${classes.chosen}`}>
          <p className="strong">
            {choice.said === null
              ? 'Nothing chosen'
              : [SAID_WORDS[choice.said], choice.amountDb === null ? '' : signed(choice.amountDb)]
                  .filter(Boolean)
                  .join(', ')}
          </p>
          <p className="small mid">
            {[choice.said && taskOf(choice.said), next ? `Next: ${next}` : 'This is the last one']
              .filter(Boolean)
              .join('. ')}
          </p>
        </div>
        {onUndo && (
          <Button variant="quiet" icon="turn" tall keys="u" onClick={onUndo}>
            Undo
          </Button>
        )}
        <Button tall keys="0" onClick={() => say('not-reached')}>
          Not reached
        </Button>
        <Button variant="primary" tall keys="Enter" disabled={choice.said === null} onClick={() => say(choice.said)}>
          Next
        </Button>
      </footer>
    </>
  )
}

interface AmountProps {
  cue: CueToHear
  choice: Choice
  onChange: (amountDb: number) => void
}

function Amount({ cue, choice, onChange }: AmountProps) {
  const isLoud = choice.said === 'too-loud'
  const amountDb = choice.amountDb ?? (isLoud ? -FIRST_DB : FIRST_DB)
  const change = (by: number) => {
    const nextDb = Math.round((amountDb + by) * 10) / 10
    const size = Math.min(MOST_DB, Math.max(0.5, isLoud ? -nextDb : nextDb))
    onChange(isLoud ? -size : size)
  }
  const list = cue.move?.changelist
  return (
    <div className={`row wrap between p-2-14px rounded ${classes.amount}`}>
      <p>
        <span className="strong">By how much?</span>{' '}
        {cue.move && (
          <span className="small mid">
            {`${cue.move.property} is at ${signed(cue.move.gain_db)}${list?.id ? ` since change ${list.id}` : ''}`}
          </span>
        )}
      </p>
      <div className={`grid items-center border-edge rounded ${classes.stepper}`}>
        <button type="button" aria-label="1 dB less" onClick={() => change(-STEP_DB)}>
          −
        </button>
        <output aria-label="Suggested gain">{signed(amountDb)}</output>
        <button type="button" aria-label="1 dB more" onClick={() => change(STEP_DB)}>
          +
        </button>
      </div>
    </div>
  )
}

function Player({ cue, projectId, buildLabel }: { cue: CueToHear; projectId: string; buildLabel: string }) {
  const [player, state] = useTakePlayer(projectId, { held: true })
  const peaks = usePeaks(cue.sound?.peaks_url)
  const gainDb = cue.gain_db ?? 0
  const heard = { url: cue.sound?.preview_url ?? '', takeId: cue.sound?.take_id }
  const shown = useMemo<Peaks | null | undefined>(
    () => peaks && (state.sourceId === 'approved' ? peaks : louder(peaks, gainDb)),
    [peaks, gainDb, state.sourceId],
  )
  const sources = {
    approved: { id: 'approved', ...heard, matchGainDb: 0 },
    built: { id: 'built', ...heard, matchGainDb: gainDb },
  }
  const hear = async (which: 'approved' | 'built') => {
    if (state.status === 'playing' && state.sourceId === which) return player.pause()
    await player.select(sources[which])
    if (!player.isPlaying()) await player.play()
  }
  useHotkeys([
    { keys: 'Space', label: 'Play as the build plays it', group: GROUP, run: () => void hear('built') },
    { keys: 'b', label: 'Play the approved level', group: GROUP, run: () => void hear('approved') },
  ])
  return (
    <section aria-label="The sound" className="grid gap-2">
      <Waveform
        plain
        label={cue.cue.name}
        peaks={shown}
        durationS={cue.sound?.duration_s ?? 1}
        heightPx={96}
        clock={player}
        onSeek={(s) => player.seek(s)}
      />
      <div className="row wrap">
        <Button icon="play" keys="Space" onClick={() => void hear('built')}>
          {`As build ${buildLabel} plays it`}
        </Button>
        <Button icon="ab" keys="b" onClick={() => void hear('approved')}>
          Approved
        </Button>
        <span className="small dim">{`The approved sound${cue.files > 1 ? ', first of its set' : ''}, at the level of the build.`}</span>
      </div>
      {state.error && <p role="alert">{state.error}</p>}
    </section>
  )
}
