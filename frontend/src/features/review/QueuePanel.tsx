import { Link, useRouter } from '@tanstack/react-router'
import { type UIEvent, useEffect, useRef } from 'react'

import { WaveThumb } from '@/audio'
import { NotHeard } from '@/heard/NotHeard'
import type { QueueItem } from '@/verdicts/api'
import { isUnheard } from '@/verdicts/afterVerdict'
import { Drafts, useDraftCount } from '@/verdicts/Drafts'
import { isFiltered, type QueueFilter } from '@/verdicts/queueFilter'
import type { Queue } from '@/verdicts/useQueue'
import {
  capital,
  counted,
  heardTakes,
  isSoon,
  deemedAcceptanceNotice,
  describeWaiting,
  urgencyReason,
} from '@/verdicts/words'
import { Button } from '@/ui/Button'
import { Count } from '@/ui/Count'
import { age, plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { KeysLine } from '@/ui/KeysLine'
import { useLazy } from '@/ui/useLazy'

import { JudgedLately } from './JudgedLately'
import classes from './Queue.module.css'

const loadFilters = () => import('./QueueFilters').then(({ QueueFilters }) => QueueFilters)

/** So far above the end of the list the next cues are asked for. */
const NEAR_PX = 600

interface QueuePanelProps {
  projectId: string
  queue: Queue
  filter: QueueFilter
  isFiltering: boolean
  onFiltering: (isFiltering: boolean) => void
  cueId: string
  mayApprove: boolean
  /** As a drawer over a narrow page. */
  opened: boolean
  onOpen: () => void
  onClose: () => void
}

/** What waits, what is noted, what was judged lately. */
export function QueuePanel(props: QueuePanelProps) {
  const { projectId, queue, filter, isFiltering, onFiltering, cueId, mayApprove, opened, onOpen, onClose } = props
  const Filters = useLazy(loadFilters, isFiltering, () => onFiltering(false))
  const waiting = queue.open
  const drafts = useDraftCount(projectId)
  const list = useRef<HTMLUListElement>(null)
  const onScroll = ({ currentTarget }: UIEvent) => {
    const below = (list.current?.getBoundingClientRect().bottom ?? 0) - currentTarget.getBoundingClientRect().bottom
    if (queue.hasMore && below < NEAR_PX) void queue.readOn()
  }
  return (
    <aside className={`flex flex-col ${classes.queue}`} aria-label="Queue" id="queue" data-opened={opened || undefined}>
      <header className={`row border-b flex-none ${classes.head}`}>
        <h2 className="nowrap">{mayApprove ? 'For you' : 'Waiting for the approver'}</h2>
        <Count of={counted(queue.waits)} what="waiting" />
        <Button
          variant="quiet"
          icon="sliders"
          square
          className="end"
          aria-label={isFiltered(filter) ? 'Filter the queue, filtered now' : 'Filter the queue'}
          aria-expanded={isFiltering}
          pressed={isFiltered(filter)}
          onClick={() => onFiltering(!isFiltering)}
        />
        <span className={classes.close}>
          <Button variant="quiet" icon="cross" square aria-label="Close queue" onClick={onClose} />
        </span>
      </header>
      {isFiltering && Filters && (
        <Filters projectId={projectId} cueId={cueId} filter={filter} onClose={() => onFiltering(false)} />
      )}
      <div className="flex-1 min-h-0 overflow-y-auto" onScroll={onScroll}>
        <ul ref={list}>
          {waiting.map((item) => (
            <QueueLine
              key={item.cue.id}
              item={item}
              projectId={projectId}
              filter={filter}
              current={item.cue.id === cueId}
              onOpen={onClose}
            />
          ))}
        </ul>
        {queue.isKnown && waiting.length === 0 && (
          <p className={`dim ${classes.sub} small`}>
            {isFiltered(filter) ? 'No cues match this filter. ' : 'Nothing to review'}
            {isFiltered(filter) && (
              <Link className="link" to="/projects/$projectId/review/$cueId" params={{ projectId, cueId }} search={{}}>
                Show all
              </Link>
            )}
          </p>
        )}
        <JudgedLately projectId={projectId} />
      </div>
      {drafts > 0 && (
        <section aria-label="Drafts, not sent" className={`border-t overflow-y-auto flex-none ${classes.drafts}`}>
          <h3 className={`dim ${classes.sub} small`}>Drafts, not sent</h3>
          <Drafts projectId={projectId} mayApprove={mayApprove} onAsk={onOpen} />
        </section>
      )}
      <footer className={`grid gap-6px border-t flex-none ${classes.foot}`}>
        <KeysLine
          keys={[
            { keys: ['j', 'k'], label: 'next, previous' },
            { keys: ['?'], label: 'all keys' },
          ]}
        />
      </footer>
    </aside>
  )
}

interface QueueLineProps {
  item: QueueItem
  projectId: string
  filter: QueueFilter
  current: boolean
  onOpen: () => void
}

function QueueLine({ item, projectId, filter, current, onOpen }: QueueLineProps) {
  const ref = useRef<HTMLAnchorElement>(null)
  const router = useRouter()
  useEffect(() => {
    if (!current) return
    const show = () => ref.current?.scrollIntoView({ block: 'nearest' })
    show()
    // The router puts the list back where it stood on the page before, once the new one is drawn.
    return router.subscribe('onRendered', show)
  }, [current, router])
  const { cue } = item
  const waits = describeWaiting(item)
  return (
    <li className={classes.item}>
      <Link
        ref={ref}
        className={`grid items-baseline hover grid-cols-1-auto border-b ${classes.itemLink}`}
        to="/projects/$projectId/review/$cueId"
        params={{ projectId, cueId: cue.id }}
        search={filter}
        aria-current={current || undefined}
        onClick={onOpen}
      >
        <span className="strong cut-text">{cue.name}</span>{' '}
        <span className="small dim nowrap num">
          {isUnheard(item) && <NotHeard />} {age(item.waiting_since)}
        </span>{' '}
        <span className={`grid col-span-full ${classes.itemWave}`}>
          <WaveThumb peaks={heardTakes(item)[0]?.thumb ?? null} highlighted={current} heightPx={24} />
        </span>
        {waits.odd ? (
          <span className="small cut-text tone-warn toned">
            <Icon name="triangle" size={14} /> {item.kind === 'alternates' && waits.before}
            {waits.odd}
          </span>
        ) : (
          <span className="small mid cut-text">{waits.before}</span>
        )}{' '}
        <span className="small dim mono num">{cue.label}</span>
        {item.is_urgent && <span className="small mid col-span-full">{capital(urgencyReason(cue))}</span>}
        {item.open_notes > 0 && (
          <span className="small mid col-span-full">{plural(item.open_notes, 'note')} still open</span>
        )}
        {item.accepted_after && (current || isSoon(item.accepted_after)) && (
          <span className="small mid col-span-full">
            {capital(deemedAcceptanceNotice(item.accepted_after, item.silence_paused_by))}
          </span>
        )}
      </Link>
    </li>
  )
}
