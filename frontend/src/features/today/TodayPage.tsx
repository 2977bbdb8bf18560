import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'
import { type ReactNode, useRef } from 'react'

import { useIsParty, useMyProject } from '@/api/me'
import { useHotkeys } from '@/app/keys'
import { NextCard } from '@/app/NextCard'
import { nextStepsQuery, stepsToName } from '@/app/nextSteps'
import { useTitle } from '@/app/title'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { Drafts, useDraftCount } from '@/verdicts/Drafts'
import { useReady } from '@/verdicts/useHearing'
import { useVerdicts } from '@/verdicts/useVerdicts'
import { useQueue } from '@/verdicts/useQueue'
import { cueMoneyQuery, moneyQuery } from '@/money/api'
import { MilestonesCard } from '@/money/MilestonesCard'
import { MoneyLine } from '@/money/MoneyLine'
import { Card, CardHead } from '@/ui/Card'
import { EmptyState } from '@/ui/EmptyState'
import { day } from '@/ui/format'
import { KeysLine } from '@/ui/KeysLine'
import { Refusal } from '@/ui/Refusal'
import { PageHead } from '@/ui/PageHead'

import { todayQuery } from './api'
import { NextUpCard } from './NextUpCard'
import { headline } from './headline'
import { UpNextList } from './UpNextList'
import { Builds, Placeholders, WithOthersCard } from './SideCards'
import classes from './Today.module.css'

/** Lines that are loaded beyond the selected one, before more are asked for. */
const AHEAD = 10

/** What waits for the current person, with the first item selected. */
export function TodayPage(): ReactNode {
  const { projectId = '' } = useParams({ strict: false })
  const now = new Date()
  useTitle('Today')
  const project = useMyProject(projectId)
  const queue = useQueue(projectId)
  const today = useQuery(todayQuery(projectId))
  const next = useQuery(nextStepsQuery(projectId))
  const drafts = useDraftCount(projectId)
  const [player, playing, heardHere] = useTakePlayer(projectId, { held: true })
  const verdicts = useVerdicts(projectId)
  const page = useRef<HTMLDivElement>(null)
  const client = useQueryClient()

  const mayApprove = project?.is_approver ?? false
  // Who runs the project and does not judge it sees money, dates and questions first.
  const isRunning = project?.is_producer === true && !mayApprove
  const first = isRunning ? undefined : queue.open[0]
  const rest = queue.items.filter((item) => item !== first)
  const money = useQuery({ ...moneyQuery(projectId), enabled: useIsParty(projectId) })
  const ofFirst = useQuery({ ...cueMoneyQuery(first?.cue.id ?? ''), enabled: first !== undefined })
  const questions = today.data?.questions ?? []
  useReady(player, first?.takes ?? [], rest[0])

  const step = (by: 1 | -1) => {
    const stops = [...(page.current?.querySelectorAll<HTMLElement>('[data-stop]') ?? [])]
    const at = stops.findIndex((stop) => stop === document.activeElement)
    if (queue.hasMore && at + AHEAD >= stops.length) void queue.readOn()
    stops[at < 0 ? (by > 0 ? 0 : stops.length - 1) : Math.min(stops.length - 1, Math.max(0, at + by))]?.focus()
  }
  useHotkeys([
    { keys: 'j', label: 'Next', group: 'Today', run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous', group: 'Today', run: () => step(-1), repeats: true },
  ])

  const loaded = queue.isKnown && today.isSuccess
  const side = today.data
  // Drawn together: early parts would move when the rest appears above or next to them.
  const settled = (queue.isKnown || queue.error !== null) && !today.isPending && !next.isPending && !money.isLoading

  const steps = next.data ? stepsToName(next.data).filter(({ kind }) => kind !== 'answer_questions') : []
  const sums = money.data?.totals.map(({ currency, figures }) => (
    <div key={currency} className="col-span-full">
      <MoneyLine
        currency={currency}
        figures={figures}
        side="team"
        projectId={projectId}
        wouldOweMinor={ofFirst.data?.currency === currency ? ofFirst.data.would_owe_minor : 0}
      />
    </div>
  ))

  return (
    <div className="page" ref={page}>
      <PageHead
        title={day(now)}
        actions={
          <div className="wide-only">
            <KeysLine
              keys={[
                { keys: ['j', 'k'], label: 'next, previous' },
                { keys: ['Enter'], label: 'open' },
                { keys: ['?'], label: 'shortcuts' },
              ]}
            />
          </div>
        }
      >
        {loaded
          ? headline({
              cues: queue.waits,
              questions: questions.length,
              drafts,
              mayApprove,
              mayAnswer: mayApprove || project?.is_producer === true || project?.is_liaison === true,
              steps: steps.length,
            })
          : '\u00a0'}
      </PageHead>
      <Refusal
        error={queue.error ?? today.error}
        action={
          <button type="button" className="link" onClick={() => void client.refetchQueries({ type: 'active' })}>
            Try again
          </button>
        }
      />
      {settled && (
        <div className={`grid items-start gap-4 mid-grid-cols-1 ${classes.today}`}>
          <div className="stack">
            <NextCard steps={steps} projectId={projectId} />
            {isRunning && sums}
            {first && (
              <NextUpCard
                key={first.cue.id}
                item={first}
                projectId={projectId}
                mayApprove={mayApprove}
                player={player}
                playing={playing}
                heardHere={heardHere}
                verdicts={verdicts}
              />
            )}
            {!first && <Refusal {...verdicts.refusal} />}
            {loaded && !first && rest.length === 0 && questions.length === 0 && steps.length === 0 && (
              <EmptyState
                head="Nothing to do"
                action={
                  <Link to="/projects/$projectId/sound-list" params={{ projectId }} search={{}} className="link">
                    Go to the sound list
                  </Link>
                }
              >
                {comesNext(today.data.counts)}
              </EmptyState>
            )}
            {isRunning && questions.length > 0 && (
              <UpNextList
                items={[]}
                questions={questions}
                projectId={projectId}
                mayApprove={false}
                title="Questions for you"
              />
            )}
            {(rest.length > 0 || (!isRunning && questions.length > 0)) && (
              <UpNextList
                items={rest}
                questions={isRunning ? [] : questions}
                projectId={projectId}
                mayApprove={mayApprove}
                title={isRunning ? 'With the approver' : first ? 'Next up' : 'For you'}
                beyond={queue.hasMore ? queue : undefined}
              />
            )}
          </div>
          {side && (
            <aside className="stack" aria-label="Also here">
              {drafts > 0 && (
                <Card aria-labelledby="drafts">
                  <CardHead id="drafts" title="Changes to send" count={drafts} end="sent together; one round per cue" />
                  <Drafts projectId={projectId} mayApprove={mayApprove} />
                </Card>
              )}
              <MilestonesCard contracts={money.data?.contracts ?? []} side="team" projectId={projectId} />
              <WithOthersCard waiting={side.with_others} awaited={next.data?.awaited ?? []} projectId={projectId} />
              <Builds builds={side.builds} />
              <Placeholders
                count={side.placeholders}
                mails={project?.is_producer ? side.unsent_mails : 0}
                projectId={projectId}
              />
            </aside>
          )}
          {!isRunning && sums}
        </div>
      )}
    </div>
  )
}

/** What will come, when nothing waits now. */
function comesNext(counts: Record<string, number | undefined>): string {
  const of = (...statuses: string[]) => statuses.reduce((sum, status) => sum + (counts[status] ?? 0), 0)
  const checking = of('checking')
  const withDesigners = of('returned', 'change_requested', 'unjudged')
  const toMake = of('to_make', 'placeholder', 'partly_accepted')
  const parts = [
    checking > 0 ? `${checking} being checked` : '',
    withDesigners > 0 ? `${withDesigners} with designers` : '',
    toMake > 0 ? `${toMake} to do` : '',
  ].filter(Boolean)
  if (parts.length > 0) return `Next come what designers deliver: ${parts.join(', ')}.`
  return of('accepted') > 0 ? 'Every cue of the list is accepted.' : 'The sound list has no cues yet. Add them first.'
}
