import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useEffect, useMemo, useState } from 'react'

import { ApiProblem } from '@/api'
import { meQuery, useMyProject } from '@/api/me'
import { useHotkeys } from '@/app/keys'
import { NdaFirst } from '@/app/shell/NdaFirst'
import { StartPageLink } from '@/app/shell/StartPageLink'
import { useTitle } from '@/app/title'
import { type FindingMark, spotOf as playFrom } from '@/audio'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { wordsOf, worstFirst } from '@/verdicts/findings'
import { FixPanel, useFixing, useSounds } from '@/fixing'
import { loadSplitPanel, type Split, useSplit } from '@/splitting'
import { TakeSourcesPart } from '@/sources/TakeSourcesPart'
import { Card, CardHead } from '@/ui/Card'
import { PageWait } from '@/ui/PageWait'
import { Refusal } from '@/ui/Refusal'
import { ago, bytes, day, figure, range } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { StatusBadge } from '@/ui/StatusBadge'
import { useLazy } from '@/ui/useLazy'

import { type Check, checkQuery, type Finding, type Sounds, type Take, takeQuery } from './api'
import { FindingsCard } from './FindingsCard'
import { MasterCard } from './MasterCard'
import { FitCard } from './FitCard'
import { LossyCard } from './LossyCard'
import { FiguresCard, GameFilesCard, HistoryCard } from './SideCards'
import { SoundCard } from './SoundCard'
import { SourceBankCard } from './SourceBankCard'
import { ReverbCard } from './ReverbCard'
import { ReversedCard } from './ReversedCard'
import { SpectrumCard } from './SpectrumCard'
import { UpsampledCard } from './UpsampledCard'
import { LabelLine } from './LabelLine'
import classes from './Take.module.css'

/** Everything that is known of one version: what was found, what was measured, what it looks and sounds like. */
export function TakePage() {
  const { takeId } = useParams({ from: '/shell/takes/$takeId' })
  const { data: take, error } = useQuery(takeQuery(takeId))
  useTitle(take ? nameOf(take) : 'Version')
  if (take === undefined) {
    if (error instanceof ApiProblem && error.code === 'nda-needed') return <Closed />
    return <PageWait isNamed title="Version" error={error} action={<StartPageLink />} />
  }
  return <WithSounds key={take.id} take={take} />
}

/** The version of a project that its NDA keeps closed; the refusal names no project, so each that waits has its way. */
function Closed() {
  const navigate = useNavigate()
  const { data: me } = useQuery(meQuery)
  return me?.projects
    .filter(({ nda_open }) => nda_open)
    .map(({ id }) => <NdaFirst key={id} projectId={id} go={(path) => void navigate({ href: path })} />)
}

const nameOf = ({ cue, file_name, number }: Take): string =>
  `${cue?.name ?? file_name}${number === null ? '' : `, version ${number}`}`

function WithSounds({ take }: { take: Take }) {
  const { data: sounds, error: noSounds } = useSounds(take.id)
  const { data: check, error: noCheck } = useQuery(checkQuery(take))
  const client = useQueryClient()
  const isElsewhere = check != null && check.state !== take.state
  useEffect(() => {
    // The check was asked later, and has seen it move on.
    if (isElsewhere) void client.invalidateQueries({ queryKey: takeQuery(take.id).queryKey, exact: true })
  }, [client, isElsewhere, take.id])
  return (
    <TakeSheet take={take} sounds={sounds} check={check}>
      <Refusal error={noSounds ?? noCheck} />
    </TakeSheet>
  )
}

interface TakeSheetProps {
  take: Take
  sounds: Sounds | undefined
  /** null before the first check. */
  check: Check | null | undefined
  /** What went wrong. */
  children: ReactNode
}

const NONE: Finding[] = []
/** They are drawn in the large waveform above. */
const NO_MARKS: FindingMark[] = []

function TakeSheet({ take, sounds, check, children }: TakeSheetProps) {
  const navigate = useNavigate()
  const [player, playing] = useTakePlayer(take.project_id)
  const { data: me } = useQuery(meQuery)
  const project = useMyProject(take.project_id)
  const [openAt, setOpenAt] = useState<number | null>(null)
  const findings = useMemo(() => (check ? worstFirst(check.findings) : NONE), [check])
  const marks = useMemo(() => findings.map(markOf), [findings])

  const isMaker = me?.person.id === take.designer.id && (project?.engagement_kind ?? null) !== null
  const master = sounds?.master
  const fixed = {
    id: take.id,
    name: take.cue?.name ?? take.file_name,
    number: take.number,
    previewUrl: master?.preview_url ?? null,
  }
  const { data: split } = useSplit(take.id)
  const [isSplitOpen, setSplitOpen] = useState(false)
  const isSplitShown = isSplitOpen || (split !== undefined && split.state !== 'none')
  const isSplitCard = isMaker && isSplitShown
  const SplitPanel = useLazy(loadSplitPanel, isSplitCard)
  const fixing = useFixing(fixed, player, playing, { mayUse: isMaker, group: 'Version' })

  const { at: placeS } = useSearch({ from: '/shell/takes/$takeId' })
  useEffect(() => {
    if (placeS === undefined || fixed.previewUrl === null) return
    void player.select({ id: take.id, takeId: take.id, url: fixed.previewUrl })
    player.seek(placeS)
  }, [player, take.id, fixed.previewUrl, placeS])

  const jump = (at: number, plays: boolean) => {
    setOpenAt(at)
    const startS = findings[at]?.start_s ?? null
    if (startS === null || fixed.previewUrl === null) return
    void player.select({ id: take.id, takeId: take.id, url: fixed.previewUrl })
    if (plays) void player.play(playFrom(startS))
    else player.seek(startS)
  }
  const step = (by: number) => {
    if (findings.length > 0) jump(((openAt ?? (by > 0 ? -1 : 0)) + by + findings.length) % findings.length, false)
  }
  const back = () => {
    if (project?.part === 'designer') {
      void navigate({ to: '/projects/$projectId/desk', params: { projectId: take.project_id } })
    } else if (take.cue) {
      void navigate({
        to: '/projects/$projectId/sound-list/cues/$cueId',
        params: { projectId: take.project_id, cueId: take.cue.id },
      })
    } else void navigate({ to: '/projects/$projectId/sound-list', params: { projectId: take.project_id } })
  }
  const none = findings.length === 0
  useHotkeys([
    { keys: 'j', label: 'Next finding', group: 'Version', run: () => step(1), disabled: none },
    { keys: 'k', label: 'Previous finding', group: 'Version', run: () => step(-1), disabled: none },
    {
      keys: 'Enter',
      label: 'Play the finding',
      group: 'Version',
      run: () => openAt !== null && jump(openAt, true),
      disabled: openAt === null,
    },
    { keys: 'Escape', label: 'Back', group: 'Version', run: back },
  ])

  const { fix } = fixing
  return (
    <div className="page">
      <Head
        take={take}
        check={check}
        isTeam={project?.part === 'team'}
        fix={fixing}
        cutFrom={split?.split_from ?? null}
      >
        {isMaker && split?.may_split && !isSplitShown && (
          <button type="button" className="link" onClick={() => setSplitOpen(true)}>
            Split into variations
          </button>
        )}
      </Head>
      {children}
      <div className="columns side-356">
        <div className="stack">
          <SoundCard
            take={take}
            sounds={sounds}
            marks={marks}
            limitDbfs={peakLimit(findings)}
            player={player}
            playing={playing}
            onMark={(at) => jump(at, true)}
          />
          <FindingsCard take={take} check={check} findings={findings} openAt={openAt} onSpot={(at) => jump(at, true)} />
          {fix && fix.state !== 'none' && (
            <Card aria-labelledby="fix">
              <CardHead id="fix" title="Fix" end={isMaker ? undefined : 'for the designer to use'} />
              <div className={`p-3-inset-14px ${classes.fix}`}>
                <FixPanel
                  take={fixed}
                  durationS={master?.duration_s ?? null}
                  peaksUrl={master?.peaks_url ?? null}
                  fixing={fixing}
                  player={player}
                  findings={NO_MARKS}
                  limitDbfs={peakLimit(findings)}
                  mayUse={isMaker}
                />
              </div>
            </Card>
          )}
          {SplitPanel && isSplitCard && (
            <Card aria-labelledby="split">
              <CardHead id="split" title="Split into variations" />
              <div className={`p-3-inset-14px ${classes.fix}`}>
                <SplitPanel
                  projectId={take.project_id}
                  takeId={take.id}
                  fileName={take.file_name}
                  cueId={take.cue?.id ?? null}
                  onHear={
                    fixed.previewUrl === null
                      ? undefined
                      : (fromS) => {
                          void player.select({ id: take.id, takeId: take.id, url: fixed.previewUrl ?? '' })
                          void player.play(fromS)
                        }
                  }
                />
              </div>
            </Card>
          )}
          <SpectrumCard peaksUrl={master?.peaks_url ?? null} check={check} />
          <ReverbCard take={take} check={check} isMaker={isMaker} />
          <ReversedCard check={check} />
          <UpsampledCard check={check} />
          <LossyCard check={check} />
          {project && <FitCard take={take} />}
        </div>
        <aside className="stack" aria-label="Measurements of this version">
          <FiguresCard check={check} findings={findings} />
          <MasterCard take={take} closed={sounds?.closed ?? null} />
          <Card aria-labelledby="sources">
            <CardHead id="sources" title="Sources" />
            <div className="p-3-inset-14px">
              <TakeSourcesPart takeId={take.id} mayState={isMaker} />
            </div>
          </Card>
          <SourceBankCard take={take} isMaker={isMaker} />
          {sounds && sounds.renders.length > 0 && <GameFilesCard files={sounds.renders} />}
          <HistoryCard takeId={take.id} />
        </aside>
      </div>
    </div>
  )
}

function markOf(finding: Finding, at: number): FindingMark {
  return {
    id: String(at),
    severity: finding.severity,
    label: wordsOf(finding).head,
    startS: finding.start_s ?? undefined,
    endS: finding.end_s ?? undefined,
  }
}

/** The lowest peak limit that something was found against, for the line in the wave. */
function peakLimit(findings: readonly Finding[]): number | undefined {
  const limits = findings.flatMap(({ check, limit }) => (check.endsWith('-peak') && limit !== null ? [limit] : []))
  return limits.length > 0 ? Math.min(...limits) : undefined
}

interface HeadProps {
  take: Take
  check: Check | null | undefined
  isTeam: boolean
  fix: ReturnType<typeof useFixing>
  /** The file that it was cut from. */
  cutFrom: Split['split_from']
  /** Further ways to go. */
  children: ReactNode
}

function Head({ take, check, isTeam, fix, cutFrom, children }: HeadProps) {
  const { cue, state, project_id: projectId } = take
  const origin = fix.fix?.fixed_from
  const waiver = check?.waiver
  return (
    <header className={`flex items-start between gap-4 mb-4 ${classes.head}`}>
      <div>
        <div className={`flex wrap items-center ${classes.names}`}>
          <h1>{cue?.name ?? take.file_name}</h1>
          <StatusBadge kind={state === 'received' ? 'checking' : state} pill />
          {waiver && <StatusBadge kind="waived" reason={waiver.reason} />}
          <span className="small dim">
            {cue && <span className="mono">{cue.label}</span>}
            {take.variation > 1 && `, _${String(take.variation).padStart(2, '0')}`}
            {take.number !== null && `, version ${take.number}`}
            {take.alternate !== null && ` ${String.fromCharCode(64 + take.alternate)}`}
            {take.label !== null && `, ${take.label}`}
          </span>
        </div>
        <p className="mid">
          <span className="mono">{take.file_name}</span>, {bytes(take.master_bytes)}, from {take.designer.name},{' '}
          <time dateTime={take.received_at} title={day(take.received_at)}>
            {ago(take.received_at)}
          </time>{' '}
          in its{' '}
          <Link className="link" to="/deliveries/$deliveryId" params={{ deliveryId: take.delivery_id }}>
            delivery
          </Link>
          {take.late && ', after it was closed'}.
        </p>
        {take.received_name && (
          <p className="mid">
            Renamed before the upload from <span className="mono">{take.received_name}</span>.
          </p>
        )}
        {origin && (
          <p className="mid">
            A fix of{' '}
            <Link className="link" to="/takes/$takeId" params={{ takeId: origin.take_id }}>
              version {origin.number}
            </Link>
            , with the consent of {origin.used_by.name}: {origin.repairs.map(({ words }) => words).join(', ')}.
          </p>
        )}
        {cutFrom && (
          <p className="mid">
            Cut from{' '}
            <Link className="link" to="/takes/$takeId" params={{ takeId: cutFrom.take_id }}>
              <span className="mono">{cutFrom.file_name}</span>
            </Link>
            {cutFrom.start_s !== null && cutFrom.end_s !== null && `, ${range(cutFrom.start_s, cutFrom.end_s)}`}: frames{' '}
            {figure(cutFrom.first_frame)} to {figure(cutFrom.end_frame)}.
          </p>
        )}
        {take.note && <p className="mid">“{take.note}”</p>}
        {cue && <LabelLine take={take} />}
        <p className={`flex wrap ${classes.ways}`}>
          {cue && (
            <Link
              className="link"
              to="/projects/$projectId/sound-list/cues/$cueId"
              params={{ projectId, cueId: cue.id }}
            >
              Cue
            </Link>
          )}
          {cue && isTeam && (
            <Link
              className="link"
              to="/projects/$projectId/review/$cueId"
              params={{ projectId, cueId: cue.id }}
              search={{ take: take.id }}
            >
              Open in review
            </Link>
          )}
          {!isTeam && (
            <Link className="link" to="/projects/$projectId/desk" params={{ projectId }}>
              Your desk
            </Link>
          )}
          {children}
        </p>
      </div>
      <div className="wide-only">
        <KeysLine
          keys={[
            { keys: ['Space'], label: 'play' },
            { keys: ['j', 'k'], label: 'findings' },
            { keys: ['Enter'], label: 'position' },
            { keys: ['?'], label: 'shortcuts' },
          ]}
        />
      </div>
    </header>
  )
}
