import { useHotkeys } from '@/app/keys'
import type { Player } from '@/audio'
import type { ReviewTake } from '@/verdicts/api'

/** What the keys of one cue's review act on. */
interface RoomActs {
  heard: readonly ReviewTake[]
  isSet: boolean
  /** The digits are those of reasons. */
  asking: boolean
  choose: (take: ReviewTake) => void
  pick: (extend: boolean) => void
  setEnd: (end: 'startS' | 'endS') => void
  targets: readonly string[]
  target: string
  onTarget: (target: string) => void
  write: (text?: string) => void
  playRandomized: () => void
  player: Player
}

/** The keys of one cue's review; those of the verdict are its own. */
export function useRoomKeys(acts: RoomActs): void {
  const { heard, isSet, asking, choose, pick, setEnd, targets, target, onTarget, write, playRandomized, player } = acts
  useHotkeys([
    ...heard.slice(0, 9).map((take, index) => ({
      keys: String(index + 1),
      label: isSet ? 'Choose a variation' : 'Choose an alternate',
      group: 'Review',
      unlisted: index > 0,
      disabled: asking,
      run: () => choose(take),
    })),
    { keys: '[', label: 'Loop from here', group: 'Review', run: () => setEnd('startS') },
    { keys: ']', label: 'Loop to here', group: 'Review', run: () => setEnd('endS') },
    {
      keys: 't',
      label: 'Master, then each game file',
      group: 'Review',
      run: () => onTarget(targets[(targets.indexOf(target) + 1) % targets.length] ?? target),
      disabled: targets.length < 2,
    },
    { keys: 'x', label: 'Select the variation', group: 'Review', run: () => pick(false), disabled: !isSet },
    { keys: 'shift+x', label: 'Select range to here', group: 'Review', run: () => pick(true), disabled: !isSet },
    { keys: 'c', label: 'Comment here', group: 'Review', run: () => write() },
    { keys: 'y', label: 'Leave a positive note', group: 'Review', run: () => write('Keep this. ') },
    {
      keys: 'h',
      label: 'Hold to play the set randomised, as in game',
      group: 'Review',
      run: playRandomized,
      release: () => player.pause(),
      disabled: !isSet,
    },
  ])
}
