import { Textarea, TextInput } from '@mantine/core'
import { type ReactNode, useState } from 'react'

import { HotkeyButton, useHotkeys } from '@/app/keys'
import { useCommands, useSearchProvider } from '@/app/palette'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { WaveThumb } from '@/audio'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ListTable } from '@/ui/Table'
import { EmptyState } from '@/ui/EmptyState'
import { Avatar } from '@/ui/Avatar'
import { FieldError } from '@/ui/FieldError'
import { FilterChip } from '@/ui/FilterChip'
import { Finding } from '@/ui/Finding'
import { place } from '@/ui/format'
import { Key } from '@/ui/Key'
import { KeysLine } from '@/ui/KeysLine'
import { Meter } from '@/ui/Meter'
import { UnreadDot } from '@/ui/UnreadDot'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { Row, Rows } from '@/ui/Rows'
import { Segmented } from '@/ui/Segmented'
import { SetBlocks } from '@/ui/SetBlocks'
import { StatusBadge, STATES, type StateKind } from '@/ui/StatusBadge'
import { VerdictBar } from '@/ui/VerdictBar'

import { CUE_COLUMNS, CUES } from './cues'
import classes from './Parts.module.css'
import { peaksOf, SAMPLES } from './sounds'
import { Stage } from './Stage'
import { Waiting } from './Waiting'

const REASONS = [
  'Too loud',
  'Too quiet',
  'Too long',
  'Too short',
  'Too late or early',
  'Wrong material',
  'Wrong size or weight',
  'Does not fit the palette',
  'Other, in words',
]

/** Every part in its states, for those who build. */
export function PartsPage() {
  useTitle('Parts')
  useCommands([
    { id: 'add', label: 'Add a cue', icon: 'plus', keys: 'n', run: () => showToast('A cue was added.') },
    { id: 'ask', label: 'Ask about shield_hit', icon: 'question', keys: 'q', run: () => showToast('Asked.') },
  ])
  useSearchProvider({
    id: 'parts',
    title: 'Sounds',
    search: (query) =>
      Promise.resolve(
        CUES.flatMap(({ rows }) => rows)
          .filter(({ name }) => name.includes(query))
          .map((cue) => ({
            id: cue.number,
            number: cue.number,
            title: cue.name,
            detail: <StatusBadge kind={cue.state} />,
            open: () => showToast(`${cue.name} opened.`),
          })),
      ),
  })

  return (
    <div className="page">
      <div className="flex wrap items-center between gap-2-4 mb-4">
        <h1>Parts</h1>
        <KeysLine
          keys={[
            { keys: ['j', 'k'], label: 'next, previous' },
            { keys: ['Space'], label: 'play' },
            { keys: ['?'], label: 'shortcuts' },
          ]}
        />
      </div>
      <div className={`grid grid-cols-2 items-start gap-4 ${classes.columns}`}>
        <div className="stack">
          <States />
          <Buttons />
          <Findings />
          <Uploads />
          <Verdict />
        </div>
        <div className="stack">
          <Palette />
          <Reasons />
          <Panel title="Empty">
            <EmptyState head="Nothing to do." level={3} action={<Button keys="p">Hear the accepted palette</Button>}>
              The next sounds are due on Friday: 3 cues of Alpha.
            </EmptyState>
          </Panel>
          <Fields />
          <Lines />
        </div>
      </div>
      <Waiting />
      <Stage />
      <List />
    </div>
  )
}

function Panel({ title, children }: { title: string; children: ReactNode }) {
  return (
    <Card className={classes.panel} aria-label={title}>
      <h2 className="micro dim">{title}</h2>
      {children}
    </Card>
  )
}

function States() {
  return (
    <Panel title="States: icon, word, colour; resting states keep a quiet word">
      <div className={`grid items-center justify-items-start ${classes.chips}`}>
        {(Object.keys(STATES) as StateKind[]).map((kind) => (
          <StatusBadge
            key={kind}
            kind={kind}
            reason={kind === 'waived' ? 'Clipping is intended in this gun.' : undefined}
          />
        ))}
        <StatusBadge kind="accepted">5 of 8 accepted</StatusBadge>
        <StatusBadge kind="to_review" pill />
        <StatusBadge kind="returned" pill />
        <StatusBadge kind="change_requested" pill />
      </div>
    </Panel>
  )
}

function Buttons() {
  const [listen, setListen] = useState<'master' | 'game' | 'handheld'>('master')
  const [looping, setLooping] = useState(true)
  const [filter, setFilter] = useState<StateKind | 'all'>('all')
  return (
    <Panel title="Buttons, keys, filters: rest, first, pressed, off">
      <div className="row wrap mt-2">
        <Button icon="play">Play</Button>
        <HotkeyButton
          variant="primary"
          icon="tick"
          keys="a"
          keyLabel="Approve"
          keyGroup="Parts"
          onPress={() => showToast('shield_hit A approved. Alpha is 4 of 10.', () => undefined)}
        >
          Approve A
        </HotkeyButton>
        <HotkeyButton
          icon="loop"
          keys="l"
          keyLabel="Loop"
          keyGroup="Parts"
          pressed={looping}
          onPress={() => setLooping(!looping)}
        >
          Loop
        </HotkeyButton>
        <Button disabled>Off</Button>
        <Button variant="quiet">Reply</Button>
        <Button icon="copy" square variant="quiet" aria-label="Copy a link" />
        <Segmented
          label="Listen to"
          value={listen}
          onChange={setListen}
          options={[
            { value: 'master', label: 'Master' },
            { value: 'game', label: 'Game' },
            { value: 'handheld', label: 'Handheld' },
          ]}
        />
      </div>
      <div className="row wrap mt-2">
        <FilterChip count={24} pressed={filter === 'all'} onPress={() => setFilter('all')}>
          All
        </FilterChip>
        {(['to_review', 'returned', 'change_requested', 'accepted'] as const).map((kind) => (
          <FilterChip key={kind} kind={kind} count={4} pressed={filter === kind} onPress={() => setFilter(kind)} />
        ))}
      </div>
    </Panel>
  )
}

function Findings() {
  return (
    <Panel title="Finding: what, the limit, where, what to do">
      <Finding
        severity="error"
        head="Sample peak 0.0 dBFS"
        where={place(0.418)}
        actions={
          <>
            <Button icon="play">The spot</Button>
            <Button icon="spanner">Fix: −1.7 dB</Button>
          </>
        }
      >
        The limit is −0.1. Lower the file by 0.1 dB or more, or use the auto-fix.
      </Finding>
      <Finding severity="warning" head="Is there reverb in it?" where="0.6 s tail">
        The engine adds reverb to impacts. This one seems to bring its own: score 0.81. The approver decides.
      </Finding>
    </Panel>
  )
}

const SENT: { name: string; share: number; state: StateKind; words?: string }[] = [
  { name: 'warp_in.wav', share: 0.41, state: 'sending', words: '0.3 of 0.8 MB' },
  { name: 'void_whale.wav', share: 0.63, state: 'line_lost' },
  { name: 'drone_swarm_loop.wav', share: 1, state: 'checking' },
  { name: 'suit_hit.wav', share: 1, state: 'conforming' },
  { name: 'airlock_cycle.wav', share: 1, state: 'returned' },
]

function Uploads() {
  return (
    <Panel title="Files on their way">
      <Rows className={classes.flush}>
        {SENT.map(({ name, share, state, words }) => (
          <Row key={name} dense>
            <span className="mono grow cut-text">{name}</span>
            <span className={classes.bar}>
              <Meter thin label={`${Math.round(share * 100)} % sent`} whole={1} parts={[{ value: share }]} />
            </span>
            <span className={classes.state}>
              <StatusBadge kind={state}>{words}</StatusBadge>
            </span>
          </Row>
        ))}
      </Rows>
    </Panel>
  )
}

function Verdict() {
  return (
    <Card aria-label="Verdict bars" className={classes.bars}>
      <VerdictBar who="You decide. Round 0 of 2." follows="A makes Alpha 4 of 10. B and C are kept.">
        <Button tall icon="comment" keys="c">
          Comment
        </Button>
        <Button tall icon="pencil" iconTone="change" keys="r">
          Request a change
        </Button>
        <Button tall variant="primary" icon="tick">
          Approve A
        </Button>
      </VerdictBar>
    </Card>
  )
}

function Palette() {
  return (
    <Panel title="Find or do, what was done">
      <div className="row wrap">
        <Button onClick={() => showToast('shield_hit A approved. Alpha is 4 of 10.', () => undefined)}>
          Show what was done
        </Button>
        <span className="mid">
          <Key keys="mod+k" /> opens the palette
        </span>
      </div>
    </Panel>
  )
}

function Reasons() {
  const [reason, setReason] = useState<number | null>(null)
  useHotkeys(
    REASONS.map((label, index) => ({
      keys: `${index + 1}`,
      label,
      group: 'Reasons',
      unlisted: true,
      run: () => setReason(index),
    })),
  )
  return (
    <Panel title="Request a change: one key for the reason">
      <div className={`grid grid-cols-1fr-1fr ${classes.reasons}`}>
        {REASONS.map((label, index) => (
          <span key={label} className={index === reason ? 'row strong' : 'row'}>
            <Key keys={`${index + 1}`} />
            {label}
          </span>
        ))}
      </div>
    </Panel>
  )
}

function Fields() {
  const [name, setName] = useState('Coolant Splash.wav')
  const wrong = name !== 'coolant_splash.wav'
  return (
    <Panel title="Fields: what was typed stays">
      <TextInput
        label="File name"
        value={name}
        onChange={(event) => setName(event.currentTarget.value)}
        error={wrong}
        aria-describedby={wrong ? 'name-error' : undefined}
      />
      {wrong && (
        <FieldError
          id="name-error"
          correction={{ label: 'Use coolant_splash.wav', apply: () => setName('coolant_splash.wav') }}
        >
          Capitals and spaces do not match this project’s names.
        </FieldError>
      )}
      <Textarea mt="md" label="Description" placeholder="What happens, to what, where" autosize minRows={2} />
      <div className="mt-2">
        <ErrorBanner
          detail="The audio director decides on weapons."
          fix="You can comment or say which you would take."
        />
      </div>
    </Panel>
  )
}

function Lines() {
  return (
    <Card>
      <CardHead title="Then" count={3} end="what blocks others first, then the oldest" />
      <Rows>
        <Row selected>
          <UnreadDot />
          <span className="strong grow cut-text">shield_hit</span>
          <span className={classes.thumb}>
            <WaveThumb peaks={SHIELD} highlighted heightPx={26} />
          </span>
          <StatusBadge kind="to_review" />
          <span className="small dim">now</span>
        </Row>
        <Row>
          <Avatar name="Audio director" />
          <span className="grow cut-text">foot_deck_walk</span>
          <SetBlocks blocks={Array.from({ length: 6 }, () => ({ tone: 'review' as const }))} />
          <span className="small dim">2 days</span>
        </Row>
        <Row>
          <span className="grow">Alpha</span>
          <span className={classes.wide}>
            <Meter
              label="3 of 10 accepted, 4 to review, 1 returned, 1 question"
              whole={10}
              parts={[
                { value: 3, tone: 'ok' },
                { value: 4, tone: 'review' },
                { value: 1, tone: 'bad' },
                { value: 1, tone: 'warn' },
              ]}
            />
          </span>
          <span>3 of 10</span>
        </Row>
      </Rows>
    </Card>
  )
}

const SHIELD = peaksOf(SAMPLES.shieldA, 200)

function List() {
  const [selected, setSelected] = useState('SW-007')
  const numbers = CUES.flatMap(({ rows }) => rows.map(({ number }) => number))
  const move = (step: number) => {
    const next = numbers[numbers.indexOf(selected) + step]
    if (next) setSelected(next)
  }
  useHotkeys([
    { keys: 'j', label: 'Next', group: 'Parts', repeats: true, run: () => move(1) },
    { keys: 'k', label: 'Previous', group: 'Parts', repeats: true, run: () => move(-1) },
  ])
  return (
    <section aria-label="Sound list" className="mt-4">
      <ListTable
        label="Sound list"
        columns={CUE_COLUMNS}
        groups={CUES}
        keyOf={({ number }) => number}
        selected={selected}
        onSelect={({ number }) => setSelected(number)}
      />
    </section>
  )
}
