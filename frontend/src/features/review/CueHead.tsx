import { useState } from 'react'

import { DraftNote, useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import type { CueReview, ReviewTake } from '@/judging/api'
import { useDraftCount } from '@/judging/Drafts'
import { inOrder, MASTER, variationName } from '@/judging/hearing'
import { asked, capital } from '@/judging/words'
import { STATE_OF_TAKE } from '@/judging/stateOfTake'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { LazyMenu } from '@/ui/LazyMenu'
import { Segmented } from '@/ui/Segmented'
import { State, type StateKind } from '@/ui/State'

import { useCut } from './api'
import classes from './Review.module.css'

interface CueHeadProps {
  review: CueReview
  hand: ReviewTake | undefined
  waitingHere: boolean
  /** Blind listening: everything that identifies a version is hidden. */
  blind: boolean
  targets: readonly string[]
  target: string
  onTarget: (target: string) => void
  onTake: (take: ReviewTake) => void
  projectId: string
  mayCut: boolean
  onCut: () => void
  queued: number | string
  onQueue: () => void
}

const loadMore = () => import('./CueMenus').then(({ MoreMenu }) => MoreMenu)
const loadVersions = () => import('./CueMenus').then(({ VersionsMenu }) => VersionsMenu)

/** Which cue it is, what was asked for, which version and which file of it is heard. */
export function CueHead(props: CueHeadProps) {
  const { review, hand, targets, target } = props
  const { cue } = review
  const [cutting, setCutting] = useState(false)
  const drafts = useDraftCount(props.projectId)
  const state = headState(review, props.waitingHere)
  return (
    <header className={classes.cue}>
      <div className={classes.cueLine}>
        <div className="grow">
          <div className={`row wrap ${classes.cueName}`}>
            <h1>{cue.name}</h1>
            <State kind={state} pill />
            <span className="small dim mono">{cue.label}</span>
          </div>
          <p className="mid">{cue.description || cue.use}</p>
          <p className="small dim">{asked(cue)}</p>
        </div>
        <div className={`row ${classes.cueActs}`}>
          <span className={classes.queueButton}>
            <Button icon="headphones" onClick={props.onQueue} aria-controls="queue">
              {props.queued} waiting
            </Button>
            {drafts > 0 && <Button onClick={props.onQueue}>{plural(drafts, 'change')} to send</Button>}
          </span>
          {targets.length > 1 && (
            <Segmented
              label="Listen to"
              value={target}
              onChange={props.onTarget}
              options={targets.map((one) => ({ value: one, label: one === MASTER ? 'Master' : capital(one) }))}
            />
          )}
          {review.takes.length > 0 && !props.blind && <Versions review={review} hand={hand} onTake={props.onTake} />}
          {props.mayCut && cue.state !== 'cut' && (
            <LazyMenu
              button={<Button icon="sliders" square aria-label={`More for ${cue.name}`} />}
              load={loadMore}
              given={{ projectId: props.projectId, cueId: cue.id, onCut: () => setCutting(true) }}
            />
          )}
        </div>
      </div>
      {cutting && (
        <CutForm
          cueId={cue.id}
          name={cue.name}
          projectId={props.projectId}
          onClose={() => setCutting(false)}
          onCut={props.onCut}
        />
      )}
    </header>
  )
}

function headState({ cue, accepted, takes }: CueReview, waiting: boolean): StateKind {
  if (cue.state === 'cut') return 'cut'
  if (waiting) return 'to_review'
  if (accepted) return 'accepted'
  const newest = takes[0]
  return newest ? STATE_OF_TAKE[newest.state] : 'to_make'
}

interface VersionsProps {
  review: CueReview
  hand: ReviewTake | undefined
  onTake: (take: ReviewTake) => void
}

/** Every version that was delivered, still there to be heard. */
function Versions({ review, hand, onTake }: VersionsProps) {
  const isSet = review.cue.variations > 1
  const versions = inOrder(review.takes).filter((take) => !isSet || take.variation === hand?.variation)
  return (
    <LazyMenu
      button={
        <Button>
          {hand ? `Version ${hand.number}` : 'Versions'} of {versions.length}
          <Icon name="chevron" />
        </Button>
      }
      load={loadVersions}
      given={{
        title: isSet && hand ? `Versions of ${variationName(hand.variation)}` : 'Versions',
        versions: versions.toReversed(),
        hand,
        onTake,
      }}
    />
  )
}

interface CutFormProps {
  cueId: string
  name: string
  projectId: string
  onClose: () => void
  onCut: () => void
}

function CutForm({ cueId, name, projectId, onClose, onCut }: CutFormProps) {
  const [reason, setReason, draft] = useDraft(`cut:${cueId}`, '')
  const cut = useCut(projectId, cueId)
  const submit = () => {
    const said = reason.trim()
    if (said === '' || cut.isPending) return
    cut.mutate(said, {
      onSuccess: () => {
        draft.discard()
        showToast(`${name} cut. Its versions are kept.`)
        onCut()
      },
    })
  }
  return (
    <form
      className={classes.cut}
      onSubmit={(event) => {
        event.preventDefault()
        submit()
      }}
    >
      <p className="small mid">Cut {name}? It stays in the list with the reason and its versions.</p>
      <div className="row">
        <input
          // The line was opened to be written in.
          // eslint-disable-next-line jsx-a11y/no-autofocus
          autoFocus
          className={`line-field ${classes.field}`}
          aria-label={`Why cut ${name}?`}
          placeholder="Reason"
          maxLength={10_000}
          value={reason}
          onChange={(event) => setReason(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === 'Escape') onClose()
          }}
        />
        <Button onClick={onClose}>Cancel</Button>
        <Button type="submit" icon="struckRing" disabled={cut.isPending || reason.trim() === ''}>
          Cut {name}
        </Button>
      </div>
      <DraftNote draft={draft} />
      <Refusal error={cut.error} />
    </form>
  )
}
