import { cueMoneyQuery } from '@/money/api'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useNavigate, useParams, useSearch } from '@tanstack/react-router'
import { type ReactNode, useEffect, useState } from 'react'

import { useMyProject } from '@/api/me'
import { useHotkeys } from '@/app/keys'
import { useTitle } from '@/app/title'
import { showToast } from '@/app/toast'
import { useTakePlayer } from '@/heard/useTakePlayer'
import { isUnheard, nextAfter } from '@/verdicts/afterVerdict'
import { firstUnheard, queueQuery, reviewQuery } from '@/verdicts/api'
import { inOrder, MASTER } from '@/verdicts/hearing'
import { usePeaksAhead } from '@/verdicts/peaks'
import { filterOf } from '@/verdicts/queueFilter'
import { useReady } from '@/verdicts/useHearing'
import { useVerdicts } from '@/verdicts/useVerdicts'
import { usePreference } from '@/verdicts/usePreference'
import { useQueue } from '@/verdicts/useQueue'
import { counted } from '@/verdicts/words'
import { Refusal } from '@/ui/Refusal'

import { CueRoom } from './CueRoom'
import { QueuePanel } from './QueuePanel'
import classes from './Review.module.css'
import { useCondition } from './useCondition'

const NONE: never[] = []
const AHEAD = 3

/** The room where cues are heard, spoken of and decided, one after another. */
export function ReviewPage(): ReactNode {
  const { projectId = '', cueId = '' } = useParams({ strict: false })
  const search = useSearch({ strict: false })
  const navigate = useNavigate()
  const client = useQueryClient()
  const project = useMyProject(projectId)
  const filter = filterOf(search)
  const queue = useQueue(projectId, cueId, filter)
  const { items, open: waiting } = queue
  const { data: review, error } = useQuery(reviewQuery(cueId))
  // Sums are a matter of producers and of the cue's own designer; who decides and neither is, needs none to decide.
  const seesMoney = project?.is_producer === true || project?.part === 'designer'
  const { data: money } = useQuery({ ...cueMoneyQuery(cueId), enabled: seesMoney })
  const [player, playing, heardHere] = useTakePlayer(projectId, { held: true, light: true })
  const conditions = useCondition(player)
  const [queueOpen, setQueueOpen] = useState(false)
  const [isFiltering, setFiltering] = useState(false)
  const [target, setTarget] = useState(MASTER)
  const [playsNext, setPlaysNext] = usePreference('soundlist-plays-next', true)
  /** The cue that opens because another was judged. */
  const [follows, setFollows] = useState<string>()
  useTitle(review ? `Review ${review.cue.name}` : 'Review')

  const open = (id: string) =>
    void navigate({
      to: '/projects/$projectId/review/$cueId',
      params: { projectId, cueId: id },
      search: filter,
    })
  const verdicts = useVerdicts(projectId, open, filter)

  const at = waiting.findIndex(({ cue }) => cue.id === cueId)
  const ahead = at < 0 ? waiting : [...waiting.slice(at + 1), ...waiting.slice(0, at)]
  const takes = waiting[at]?.takes ?? NONE
  useReady(player, takes, ahead[0], ahead.slice(1, AHEAD), ahead.slice(AHEAD))
  usePeaksAhead(inOrder(takes)[0]?.peaks_url, ahead[0]?.takes ?? NONE)
  const aheadIds = ahead
    .slice(0, AHEAD)
    .map(({ cue }) => cue.id)
    .join(' ')
  useEffect(() => {
    for (const id of aheadIds.split(' ').filter(Boolean)) void client.prefetchQuery(reviewQuery(id))
  }, [client, aheadIds])

  const step = async (by: 1 | -1) => {
    const place = at < 0 ? 0 : at + by
    const isBeyond = place >= waiting.length && queue.hasMore
    const to = isBeyond ? (await queue.readOn())[place] : waiting[place]
    if (to) open(to.cue.id)
  }
  const toUnheard = async () => {
    const here = ahead.find(isUnheard)
    const later = here || !queue.hasMore ? [] : await firstUnheard(projectId, filter).catch(() => NONE)
    const to = here ?? later.find(({ cue }) => items.every((item) => item.cue.id !== cue.id))
    if (to) open(to.cue.id)
    else showToast('You have heard every other version that waits.')
  }
  const toNext = () => {
    const queued = client.getQueryData(queueQuery(projectId, filter).queryKey)?.pages
    const next = nextAfter(
      items,
      cueId,
      queued?.flatMap((page) => page.items),
    )
    setFollows(next?.cue.id)
    if (next) open(next.cue.id)
    else void navigate({ to: '/projects/$projectId/review', params: { projectId }, search: filter })
  }
  useHotkeys([
    { keys: 'j', label: 'Next in the queue', group: 'Review', run: () => void step(1) },
    { keys: 'k', label: 'Previous in the queue', group: 'Review', run: () => void step(-1) },
    { keys: 'shift+j', label: 'Next that you have not heard', group: 'Review', run: () => void toUnheard() },
    {
      keys: 'g q',
      label: 'Go to queue',
      group: 'Review',
      run: () => {
        setQueueOpen(true)
        requestAnimationFrame(() => document.querySelector<HTMLElement>('#queue a')?.focus())
      },
    },
    {
      keys: 'f',
      label: 'Filter the queue',
      group: 'Review',
      run: () => {
        setQueueOpen(true)
        setFiltering(true)
      },
    },
    { keys: 'Escape', label: 'Close queue', group: 'Review', run: () => setQueueOpen(false), disabled: !queueOpen },
  ])

  return (
    <div className={`grid overflow-hidden ${classes.room}`}>
      <QueuePanel
        projectId={projectId}
        queue={queue}
        filter={filter}
        isFiltering={isFiltering}
        onFiltering={setFiltering}
        cueId={cueId}
        mayApprove={project?.is_approver ?? false}
        opened={queueOpen}
        onOpen={() => setQueueOpen(true)}
        onClose={() => setQueueOpen(false)}
      />
      {review ? (
        <CueRoom
          key={cueId}
          review={review}
          money={money ?? null}
          projectId={projectId}
          mayCut={project?.is_producer ?? false}
          seesScene={project !== undefined}
          player={player}
          playing={playing}
          heardHere={heardHere}
          conditions={conditions}
          target={target}
          onTarget={setTarget}
          verdicts={verdicts}
          waiting={counted(queue.waits)}
          onQueue={() => setQueueOpen(true)}
          onJudged={toNext}
          playsAtOnce={playsNext && follows === cueId}
          onPlayed={() => setFollows(undefined)}
          playsNext={{ on: playsNext, toggle: () => setPlaysNext(!playsNext) }}
          startTakeId={search.take}
          startS={search.at}
        />
      ) : (
        <section className={`flex flex-col bg-raised overflow-y-auto min-w-0 min-h-0 ${classes.stage}`}>
          <h1 className="visually-hidden">Review</h1>
          <Refusal error={error} />
        </section>
      )}
    </div>
  )
}
