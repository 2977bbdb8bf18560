import { useInfiniteQuery, useQuery } from '@tanstack/react-query'
import { listQuery } from '@/api/soundList'
import { Link, useNavigate, useParams } from '@tanstack/react-router'
import { type ReactNode, useCallback, useEffect, useMemo, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { ReferenceStrip, WordText } from '@/references'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day, length, lengthAsked } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { NeedMark } from '@/ui/NeedMark'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { PHASE_WORDS } from '@/phases'
import { StatusBadge } from '@/ui/StatusBadge'
import { VisionLine } from '@/vision'
import { VoiceLineWhereAny } from '@/voice-lines/VoiceLineWhereAny'
import { PageWait } from '@/ui/PageWait'

import {
  cueChangesQuery,
  type CueDetail,
  cueQuery,
  progressQuery,
  type Version,
  versionsQuery,
  useRights,
} from '../api'
import classes from './Cue.module.css'
import { CutCue } from './CutCue'
import { EditCue } from './EditCue'
import { Handoffs } from './Handoffs'
import { History } from './History'
import { keepLastCue } from '../lastCue'
import { AskForm, QuestionLine } from './Questions'
import { cuePeopleQuery, namesOf, TASKS } from '../people'
import { categoriesOf, phaseOf, rowsOf } from '../rows'
import { Versions } from './Versions'
import { SpokenPlaceholder } from '../spoken/SpokenPlaceholder'
import { REVERBS, SETTLED } from '../words'

const NO_VERSIONS: Version[] = []
const NONE: string[] = []

/** One cue: what it is, what was asked, what was delivered, and how it changed. */
export function CuePage(): ReactNode {
  const { projectId = '', cueId = '' } = useParams({ strict: false })
  const { data: cue, error } = useQuery(cueQuery(cueId))
  useTitle(cue?.name ?? 'Cue')
  if (cue === undefined) {
    return (
      <PageWait
        isNamed
        title="Cue"
        error={error}
        action={
          <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId }}>
            Go to the sound list
          </Link>
        }
      />
    )
  }
  return <CueSheet key={cue.id} cue={cue} projectId={projectId} />
}

function CueSheet({ cue, projectId }: { cue: CueDetail; projectId: string }) {
  const navigate = useNavigate()
  const rights = useRights(projectId)
  const { data: list } = useQuery(listQuery(projectId))
  const { data: progressList } = useQuery(progressQuery(projectId))
  const versions = useQuery(versionsQuery(projectId, cue.id))
  const changes = useInfiniteQuery(cueChangesQuery(projectId, cue))
  const [player, playing] = useTakePlayer(projectId)
  const [doing, setDoing] = useState<'edit' | 'cut' | null>(null)

  const cues = list?.cues
  const row = useMemo(() => rowsOf([cue], { progressList })[0], [cue, progressList])
  const categories = useMemo(() => categoriesOf((cues ?? []).map((listed) => ({ cue: listed }))), [cues])
  const at = cues?.findIndex(({ id }) => id === cue.id) ?? -1
  const delivered = versions.data ?? NO_VERSIONS

  const play = useCallback(
    (version: Version) => {
      if (version.previewUrl === null) return
      if (player.getState().sourceId === version.take.id) {
        void player.toggle()
        return
      }
      player.setLooping(cue.loop)
      void player.select({ id: version.take.id, takeId: version.take.id, url: version.previewUrl })
      void player.play(0)
    },
    [player, cue.loop],
  )
  const openCue = (by: 1 | -1) => {
    const next = cues?.[at + by]
    if (next) {
      void navigate({ to: '/projects/$projectId/sound-list/cues/$cueId', params: { projectId, cueId: next.id } })
    }
  }
  const ask = () => document.querySelector<HTMLElement>('#ask textarea')?.focus()
  const back = () => void navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })
  const isCut = cue.state === 'cut'
  const mayEdit = rights.edits && !isCut
  const first =
    delivered.find(({ take }) => take.id === playing.sourceId) ?? delivered.find((version) => version.previewUrl)
  useHotkeys([
    { keys: 'Escape', label: 'Back to the list', group: 'Cue', run: () => (doing ? setDoing(null) : back()) },
    { keys: 'j', label: 'Next cue', group: 'Cue', run: () => openCue(1), repeats: true },
    { keys: 'k', label: 'Previous cue', group: 'Cue', run: () => openCue(-1), repeats: true },
    { keys: 'Space', label: 'Play', group: 'Cue', run: () => first && play(first), disabled: !first },
    { keys: 'q', label: 'Ask a question', group: 'Cue', run: ask },
    { keys: 'e', label: 'Edit', group: 'Cue', run: () => setDoing('edit'), disabled: !mayEdit },
  ])
  useEffect(() => {
    window.scrollTo({ top: 0 })
    keepLastCue(projectId, cue.id)
  }, [projectId, cue.id])

  const stands = row?.stands
  const open = cue.questions.filter(({ answer }) => answer === null)
  const answered = cue.questions.filter(({ answer }) => answer !== null).toReversed()
  return (
    <div className={`page grid grid-cols-1 gap-3 content-start ${classes.page}`}>
      <header className="flex wrap top between gap-2-4">
        <div className={`min-w-0 ${classes.title}`}>
          <p className="row small dim">
            <Link className="link" to="/projects/$projectId/sound-list" params={{ projectId }}>
              Sound list
            </Link>{' '}
            <span className="mono">{cue.label}</span>
          </p>
          <div className="row wrap">
            <h1 className={isCut ? 'struck' : undefined}>{cue.name}</h1>
            {row && progressList && (
              <StatusBadge kind={row.kind} pill>
                {row.stateWords}
              </StatusBadge>
            )}
            {cue.placeholder && row?.kind !== 'placeholder' && !isCut && <StatusBadge kind="placeholder" pill />}
          </div>
          {stands && progressList && (
            <p className="mid">
              {stands.before}
              {stands.marked && <span className={`tone-${stands.tone} toned`}>{stands.marked}</span>}
              {stands.after}
            </p>
          )}
          <VisionLine projectId={projectId} />
        </div>
        <div className={`flex wrap gap-2 ${classes.acts}`}>
          {mayEdit && (
            <Button icon="pencil" keys="e" pressed={doing === 'edit'} onClick={() => setDoing(doing ? null : 'edit')}>
              Edit
            </Button>
          )}
          {rights.cuts && !isCut && (
            <Button icon="struckRing" onClick={() => setDoing('cut')}>
              Cut cue
            </Button>
          )}
          {rights.reviews && delivered.length > 0 && (
            <ButtonLink
              component={Link}
              variant="primary"
              icon="headphones"
              to={`/projects/${projectId}/review/${cue.id}`}
            >
              Open in review
            </ButtonLink>
          )}
        </div>
      </header>

      <div className={`columns ${classes.columns}`}>
        <div className="stack">
          <Card aria-labelledby="facts">
            <CardHead id="facts" title="Brief" end={row && `${wordOf(SETTLED, cue.state)}`} />
            {doing === 'edit' && (
              <EditCue cue={cue} projectId={projectId} categories={categories} onClose={() => setDoing(null)} />
            )}
            {doing === 'cut' && <CutCue cue={cue} projectId={projectId} onClose={() => setDoing(null)} />}
            {doing !== 'edit' && <Facts cue={cue} projectId={projectId} />}
            <div className="grid gap-3 p-3-inset-4">
              <VoiceLineWhereAny projectId={projectId} cueId={cue.id} />
              <SpokenPlaceholder cueId={cue.id} cueName={cue.name} projectId={projectId} mayEdit={mayEdit} />
              <ReferenceStrip projectId={projectId} cueId={cue.id} mayAdd={mayEdit} />
            </div>
          </Card>
          <Versions
            cue={cue}
            projectId={projectId}
            versions={versions.data}
            unheardIds={row?.progress?.unheard_take_ids ?? NONE}
            error={versions.error}
            playingId={playing.status === 'playing' || playing.status === 'loading' ? playing.sourceId : null}
            reviews={rights.reviews}
            onPlay={play}
          />
          {playing.error && <ErrorBanner detail={playing.error} />}
        </div>
        <div className="stack">
          <Card aria-labelledby="questions">
            <CardHead
              id="questions"
              title="Questions"
              note={open.length > 0 ? (open.length === 1 ? '1 unanswered' : `${open.length} unanswered`) : undefined}
            />
            <div className="grid gap-3 p-3-inset-4">
              {[...open, ...answered].map((question) => (
                <QuestionLine key={question.id} question={question} projectId={projectId} mayAnswer={rights.edits} />
              ))}
              {cue.questions.length === 0 && (
                <p className="small dim">No questions. Answers are added to the description.</p>
              )}
              {!isCut && (
                <div id="ask">
                  <AskForm cue={cue} projectId={projectId} />
                </div>
              )}
            </div>
          </Card>
          <Handoffs cue={cue} projectId={projectId} versions={delivered} />
          <History cue={cue} versions={delivered} changes={changes} />
        </div>
      </div>
      <footer className="min-h-24px">
        <KeysLine
          keys={[
            { keys: ['j', 'k'], label: 'next, previous cue' },
            { keys: ['Space'], label: 'play' },
            ...(mayEdit
              ? [
                  { keys: ['e'], label: 'edit' },
                  { keys: ['v'], label: 'say a placeholder' },
                ]
              : []),
            { keys: ['q'], label: 'ask a question' },
            { keys: ['Escape'], label: 'back to the list' },
          ]}
        />
      </footer>
    </div>
  )
}

const wordOf = (options: readonly { value: string; label: string }[], value: string): string =>
  options.find((option) => option.value === value)?.label ?? ''

function Facts({ cue, projectId }: { cue: CueDetail; projectId: string }) {
  const { data: people } = useQuery(cuePeopleQuery(projectId))
  const names = namesOf(people ?? [])
  const facts: [string, ReactNode][] = [
    ['Need', <NeedMark key="need" need={cue.need} />],
    ['Phase', PHASE_WORDS[phaseOf(cue) ?? ''] ?? null],
    ['Use in the game', cue.use],
    ['Trigger', cue.trigger && <span className="mono">{cue.trigger}</span>],
    ['Category', cue.category],
    [
      'Length',
      cue.duration_min_s !== null || cue.duration_max_s !== null
        ? lengthAsked(cue)
        : cue.duration_s !== null &&
          (cue.length_locked
            ? `${length(cue.duration_s)}, exact to a frame of ${cue.frame_rate_fps ?? 60} a second`
            : `about ${length(cue.duration_s)}`),
    ],
    ['Plays', cue.loop ? 'as a loop' : 'once'],
    ['Variations', cue.variations > 1 && `a set of ${cue.variations}`],
    ['Reverb', cue.reverb && wordOf(REVERBS, cue.reverb).toLowerCase()],
    ['Channels', cue.channels],
    ['Playback priority', cue.playback_priority],
    ['Needed by', cue.due_on && day(cue.due_on)],
    ...TASKS.map(({ fact, label }): [string, ReactNode] => [label, names.get(cue[fact] ?? '') ?? null]),
    ['Placeholder', cue.placeholder && 'the build has a placeholder, which must not ship'],
    ['Palette', cue.palette && 'reference for new sounds'],
    [
      cue.stems.length > 1 ? 'File names' : 'File name',
      cue.stems.length > 0 && <span className="mono">{cue.stems.map((stem) => `${stem}.wav`).join(', ')}</span>,
    ],
    ...Object.entries(cue.extra),
  ]
  return (
    <div className="grid gap-3 p-3-inset-4">
      {cue.description && (
        <div className={`pre-line wrap-anywhere ${classes.description}`}>
          <WordText projectId={projectId} text={cue.description} />
        </div>
      )}
      <dl className={`grid gap-2-4 ${classes.facts}`}>
        {facts
          .filter(([, value]) => value !== '' && value !== false && value !== null)
          .map(([name, value]) => (
            <div key={name}>
              <dt className="dim">{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
      </dl>
    </div>
  )
}
