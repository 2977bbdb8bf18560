import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useParams } from '@tanstack/react-router'
import { useCallback, useEffect, useMemo, useRef, useState } from 'react'

import { ApiProblem, useSettled } from '@/api'
import { meQuery } from '@/api/me'
import { AwaitedCard, NextCard } from '@/app/NextCard'
import { nextStepsQuery, stepsToName } from '@/app/nextSteps'
import { useTitle } from '@/app/title'
// eslint-disable-next-line no-restricted-imports -- of designers nothing is recorded
import { usePlayer } from '@/audio'
import { fixesQuery, fixQuery } from '@/fixing'
import { moneyQuery } from '@/money/api'
import { OwedCards } from '@/money/OwedCard'
import { EmptyState } from '@/ui/EmptyState'
import { KeysLine } from '@/ui/KeysLine'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'
import { useLazy } from '@/ui/useLazy'
import { filesOfField, type Picked, usePageDrop } from '@/uploads'

import { type Desk, deliveryQuery, openDeliveryQuery, unmatchedQuery, useCues, useDesk, useUnmatched } from './api'
import { ReturnedTakesCard } from './ReturnedTakesCard'
import { DeliveryCard } from './DeliveryCard'
import { type DeliveryUploads, uploadsOf } from './deliveryUploads'
import classes from './Desk.module.css'
import { OtherSoundsCard } from './OtherSoundsCard'
import { useCameBack, useToMake } from './pages'
import { labelsOf } from './rows'
import { SeveralSounds } from './SeveralSounds'
import { AskedCard, FixesCard, ToMakeCard, WithApproverCard } from './SideCards'
import { UndecidedFiles } from './UndecidedFiles'
import { UnmatchedTray } from './UnmatchedTray'
import { deskLine } from './words'

const loadHeldFiles = () => import('./precheck/HeldFiles').then(({ HeldFiles }) => HeldFiles)

function useDeliveryUploads(projectId: string): { uploads: DeliveryUploads | null; error: unknown } {
  const client = useQueryClient()
  const [uploads, setUploads] = useState<DeliveryUploads | null>(null)
  const [error, setError] = useState<unknown>(null)
  useEffect(() => {
    let left = false
    const start = async () => {
      try {
        const me = await client.ensureQueryData(meQuery)
        const found = await uploadsOf(client, projectId, me.person.id)
        if (!left) setUploads(found)
      } catch (refusal) {
        if (!left) setError(refusal)
      }
    }
    setUploads(null)
    setError(null)
    void start()
    return () => {
      left = true
    }
  }, [client, projectId])
  return { uploads, error }
}

/** Whether all is known that has a place of its own on the desk. Once it is drawn it stays, whatever is read again. */
function useIsDrawn(projectId: string, desk: Desk | undefined): boolean {
  const [drawnFor, setDrawnFor] = useState('')
  const { data: delivery } = useQuery(openDeliveryQuery(projectId))
  const first = desk?.came_back[0]
  const settled = useSettled([
    nextStepsQuery(projectId),
    moneyQuery(projectId),
    fixesQuery(projectId),
    openDeliveryQuery(projectId),
    ...(delivery ? [deliveryQuery(delivery.id)] : []),
    ...(desk ? [unmatchedQuery(projectId, desk.unmatched)] : []),
    ...(first ? [fixQuery(first.take_id)] : []),
  ])
  if (desk && settled && drawnFor !== projectId) setDrawnFor(projectId)
  return drawnFor === projectId
}

/** A designer's desk in one project: what came back, what goes in, what is still to make. */
export function DeskPage() {
  useTitle('Desk')
  const { projectId } = useParams({ from: '/shell/projects/$projectId/desk' })
  const { data: desk, error } = useDesk(projectId)
  const { uploads, error: noUploads } = useDeliveryUploads(projectId)
  const isDrawn = useIsDrawn(projectId, desk)
  const problem = error ?? noUploads
  if (problem) {
    return (
      <div className="page">
        <h1>Your desk</h1>
        {problem instanceof ApiProblem && problem.status === 403 ? (
          <EmptyState head="This page is for the project’s sound designers">
            You are on the game team. See Today for your tasks.
          </EmptyState>
        ) : (
          <Refusal error={problem} />
        )}
      </div>
    )
  }
  if (desk === undefined || uploads === null || !isDrawn) {
    return (
      <div className="page">
        <h1>Your desk</h1>
      </div>
    )
  }
  return <OpenDesk key={projectId} projectId={projectId} desk={desk} uploads={uploads} />
}

function OpenDesk({ projectId, desk, uploads }: { projectId: string; desk: Desk; uploads: DeliveryUploads }) {
  const [player, playing] = usePlayer()
  const { data: unmatched = [] } = useUnmatched(projectId, desk.unmatched)
  const { data: cues } = useCues(projectId)
  const { data: next } = useQuery(nextStepsQuery(projectId))
  const [problem, setProblem] = useState<unknown>(null)
  const [precheck, setPrecheck] = useState(uploads.precheck)
  const HeldFiles = useLazy(loadHeldFiles, precheck !== null)

  const add = useCallback(
    async (picked: readonly Picked[], cueId: string | null = null) => {
      setProblem(null)
      try {
        setPrecheck(await uploads.prepare())
        await uploads.add(picked, cueId)
      } catch (refusal) {
        setProblem(refusal)
      }
    },
    [uploads],
  )
  const onPageDrop = useCallback((picked: Picked[]) => void add(picked), [add])
  const over = usePageDrop(onPageDrop)
  const chooser = useFileChooser(add)
  const back = useCameBack(projectId, desk)
  const toMake = useToMake(projectId, desk)
  const labelOf = useMemo(() => labelsOf(cues ?? []), [cues])

  return (
    <div className="page">
      <PageHead
        title="Your desk"
        actions={
          <div className="wide-only">
            <KeysLine
              keys={[
                { keys: ['n'], label: 'deliver files' },
                { keys: ['Space'], label: 'play' },
                { keys: ['?'], label: 'shortcuts' },
              ]}
            />
          </div>
        }
      >
        {deskLine(desk)}
      </PageHead>
      {chooser.fields}
      <div className="columns side-356">
        <div className="stack">
          {next && <NextCard steps={stepsToName(next)} projectId={projectId} />}
          <ReturnedTakesCard
            projectId={projectId}
            back={back}
            count={back.hasMore ? desk.came_back_cues : back.items.length}
            player={player}
            playing={playing}
            onSendOwn={chooser.choose}
          />
          <DeliveryCard
            projectId={projectId}
            uploads={uploads}
            labelOf={labelOf}
            onChoose={() => chooser.choose(null)}
            onChooseFolder={chooser.chooseFolder}
            problem={problem}
            held={precheck && HeldFiles && <HeldFiles precheck={precheck} />}
          >
            <SeveralSounds projectId={projectId} player={player} />
            <UndecidedFiles projectId={projectId} />
            <UnmatchedTray
              projectId={projectId}
              takes={unmatched}
              count={desk.unmatched}
              player={player}
              playing={playing}
            />
          </DeliveryCard>
        </div>
        <aside className="stack" aria-label="Cues, reviews and questions">
          <OwedCards projectId={projectId} />
          <ToMakeCard
            projectId={projectId}
            toMake={toMake}
            count={desk.to_make_cues}
            onChoose={chooser.choose}
            onDrop={(picked, cueId) => void add(picked, cueId)}
          />
          <WithApproverCard projectId={projectId} desk={desk} />
          <FixesCard projectId={projectId} />
          <OtherSoundsCard projectId={projectId} player={[player, playing]} />
          <AwaitedCard awaited={next?.awaited ?? []} projectId={projectId} />
          <AskedCard
            projectId={projectId}
            questions={desk.questions}
            cueId={desk.came_back[0]?.cue?.id ?? desk.to_make[0]?.cue.id ?? null}
          />
        </aside>
      </div>
      {over && (
        <p className={`rounded ${classes.over} on-ink`} role="status">
          Drop files, folders or a ZIP to add them to the delivery. Drop them on a cue under “To do” to deliver that
          cue.
        </p>
      )}
    </div>
  )
}

interface Chooser {
  fields: React.ReactNode
  /** Choose files; with a cue they are for it, whatever they are called. */
  choose: (cueId: string | null) => void
  chooseFolder: () => void
}

/** The browser's own windows for choosing files and folders. */
function useFileChooser(add: (picked: readonly Picked[], cueId: string | null) => Promise<void>): Chooser {
  const files = useRef<HTMLInputElement>(null)
  const folder = useRef<HTMLInputElement>(null)
  const cue = useRef<string | null>(null)
  const take = (field: HTMLInputElement) => {
    void add(filesOfField(field.files ?? []), cue.current)
    // The same file may be chosen twice running.
    field.value = ''
  }
  const fields = (
    <span className="visually-hidden">
      <input
        ref={files}
        type="file"
        multiple
        tabIndex={-1}
        aria-label="Files to deliver"
        onChange={(event) => take(event.currentTarget)}
      />
      <input
        ref={folder}
        type="file"
        multiple
        tabIndex={-1}
        aria-label="Folder to deliver"
        onChange={(event) => take(event.currentTarget)}
        {...{ webkitdirectory: '' }}
      />
    </span>
  )
  return {
    fields,
    choose: (cueId) => {
      cue.current = cueId
      files.current?.click()
    },
    chooseFolder: () => {
      cue.current = null
      folder.current?.click()
    },
  }
}
