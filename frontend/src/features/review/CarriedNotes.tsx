import { useHotkeys } from '@/app/keys'
import type { ReviewTake } from '@/verdicts/api'
import { spot } from '@/verdicts/words'
import { Button } from '@/ui/Button'
import { Avatar } from '@/ui/Avatar'
import { Refusal } from '@/ui/Refusal'
import { age } from '@/ui/format'
import { Icon } from '@/ui/Icon'

import { useAnswerNote } from './api'
import { type Carried, isAnswered } from './carried'
import classes from './Side.module.css'

interface CarriedNotesProps {
  carried: readonly Carried[]
  hand: ReviewTake
  cueId: string
  projectId: string
  /** Whether notes that are open block approval in this project. */
  areBlocking: boolean
  onSpot: (startS: number) => void
}

/** What was said of earlier versions, each asked of this one: is it done? */
export function CarriedNotes({ carried, hand, cueId, projectId, areBlocking, onSpot }: CarriedNotesProps) {
  const answer = useAnswerNote(projectId, cueId)
  const next = carried.find((item) => !isAnswered(item, hand))
  const done = carried.filter(({ note }) => note.answer?.is_done).length
  const say = (item: Carried, isDone: boolean) => answer.mutate({ takeId: hand.id, note: item.note, isDone })
  const sayOfNext = (isDone: boolean) => {
    if (next && !answer.isPending) say(next, isDone)
  }
  const disabled = next === undefined
  useHotkeys([
    {
      keys: 'Enter',
      label: 'Note from an earlier version: done',
      group: 'Review',
      run: () => sayOfNext(true),
      disabled,
    },
    {
      keys: 'n',
      label: 'Note from an earlier version: still open',
      group: 'Review',
      run: () => sayOfNext(false),
      disabled,
    },
  ])
  return (
    <section className={`border-b ${classes.carried}`} aria-label="Carried over from earlier versions">
      <p className="row small p-10px-inset">
        <span className="strong">Carried over from earlier versions</span>
        <span className="dim end nowrap">
          {done} of {carried.length} done
        </span>
      </p>
      <ul>
        {carried.map((item) => (
          <Line
            key={item.note.id}
            carried={item}
            hand={hand}
            isNext={item === next}
            onSpot={onSpot}
            onSay={(isDone) => say(item, isDone)}
          />
        ))}
      </ul>
      {next && (
        <p className="small dim p-10px-inset">
          {areBlocking ? 'A version is approved once all are done.' : 'Approving marks what is left as done.'}
        </p>
      )}
      <Refusal error={answer.error} />
    </section>
  )
}

interface LineProps {
  carried: Carried
  hand: ReviewTake
  isNext: boolean
  onSpot: (startS: number) => void
  onSay: (isDone: boolean) => void
}

function Line({ carried, hand, isNext, onSpot, onSay }: LineProps) {
  const { note, number, startS, endS } = carried
  const { answer } = note
  const isSaid = isAnswered(carried, hand)
  const about = <span className="visually-hidden">: {note.text}</span>
  return (
    <li className={`border-b ${classes.said}`} aria-current={isNext || undefined}>
      <p className="row">
        {number !== null && <span className={`flex-none strong ${classes.saidNumber}`}>{number}</span>}
        <Avatar name={note.author.name} picture={note.author.picture} />
        <span className="strong cut-text">{note.author.name}</span>
        {startS !== null && (
          <button type="button" className="link small mono dim end nowrap" onClick={() => onSpot(startS)}>
            {spot(startS, endS)}
          </button>
        )}
      </p>
      <p className="small dim">
        {note.kind === 'change' ? 'requested a change' : note.decides ? 'approver' : 'advises'}, version {note.number}
      </p>
      <p className="wrap-anywhere">{note.text}</p>
      {answer && (
        <p className={answer.is_done ? 'small tone-ok toned' : 'small mid'}>
          {answer.is_done && <Icon name="tick" size={14} />} {answer.is_done ? 'Done' : 'Still open'} in version{' '}
          {answer.number}, {answer.given_by.name}, {age(answer.created_at)}
        </p>
      )}
      <p className="flex gap-2 mt-6px">
        <Button
          className="small"
          keys={isNext ? 'Enter' : undefined}
          pressed={isSaid && answer?.is_done === true}
          onClick={() => onSay(true)}
        >
          Done{about}
        </Button>
        <Button
          className="small"
          keys={isNext ? 'n' : undefined}
          pressed={isSaid && answer?.is_done === false}
          onClick={() => onSay(false)}
        >
          Still open{about}
        </Button>
      </p>
    </li>
  )
}
