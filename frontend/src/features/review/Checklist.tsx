import { useHotkeys } from '@/app/keys'
import type { CueReview, ReviewTake } from '@/verdicts/api'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { age } from '@/ui/format'

import classes from './Checklist.module.css'
import { useCheckItem } from './checklistApi'

interface ChecklistProps {
  checklist: CueReview['checklist']
  hand: ReviewTake
  cueId: string
  onClose: () => void
}

/** What is checked of a version before it is approved: all items, the next one with its key. */
export function Checklist({ checklist, hand, cueId, onClose }: ChecklistProps) {
  const check = useCheckItem(cueId)
  const checks = new Map(checklist.checks.filter(({ take_id }) => take_id === hand.id).map((row) => [row.item_id, row]))
  const next = checklist.items.find(({ id }) => !checks.has(id))
  const set = (itemId: string, isChecked: boolean) => {
    if (!check.isPending) check.mutate({ takeId: hand.id, itemId, isChecked })
  }
  const checkNext = () => next && set(next.id, true)
  useHotkeys([
    { keys: 'i', label: 'Check the next item', group: 'Review', run: checkNext, disabled: next === undefined },
    { keys: 'Escape', label: 'Close', group: 'Review', unlisted: true, run: onClose },
  ])
  const done = checklist.items.filter(({ id }) => checks.has(id)).length
  return (
    <section aria-label="Checklist" className="grid gap-6px">
      <div className="flex wrap items-center gap-1-3">
        <p className="small">
          <span className="strong">Checklist</span>{' '}
          <span className="mid" role="status">
            {done} of {checklist.items.length} checked
          </span>
        </p>
        <span className="flex gap-6px end">
          {next && (
            <Button keys="i" icon="tick" className="small" onClick={checkNext}>
              Check<span className="visually-hidden">: {next.text}</span>
            </Button>
          )}
          <Button variant="quiet" className="small" keys="Escape" onClick={onClose}>
            Close
          </Button>
        </span>
      </div>
      <ul className={`overflow-y-auto ${classes.items}`}>
        {checklist.items.map(({ id, text }) => {
          const checked = checks.get(id)
          return (
            <li key={id}>
              <label className={`flex top min-h-24px pointer wrap-anywhere gap-2 ${classes.item}`}>
                <input
                  type="checkbox"
                  checked={checked !== undefined}
                  onChange={(event) => set(id, event.currentTarget.checked)}
                />
                <span>{text}</span>
              </label>
              {checked && (
                <span className="small dim nowrap">
                  {checked.by.name}, {age(checked.checked_at)}
                </span>
              )}
            </li>
          )
        })}
      </ul>
      <Refusal error={check.error} />
    </section>
  )
}
