import { Button } from '@/ui/Button'
import { Meter } from '@/ui/Meter'
import { StatusBadge } from '@/ui/StatusBadge'

import classes from './Delivery.module.css'
import type { DeliveryRow } from './rows'

/** What can be done about a file of the delivery. */
export interface FileActions {
  onStop: (uploadId: string) => void
  onDismiss: (uploadId: string) => void
  onRecheck: (takeId: string) => void
}

/** One file on its way: its name, its cue, how far it is. */
export function DeliveryLine({ row, onStop, onDismiss, onRecheck }: { row: DeliveryRow } & FileActions) {
  const { name, label, state, share, detail, does, uploadId, takeId } = row
  return (
    <>
      <span className={`mono nowrap overflow-hidden text-ellipsis ${classes.name}`}>{name}</span>
      <span className="mono dim wide-only nowrap overflow-hidden text-ellipsis">{label}</span>
      <span className={`grid gap-2px wrap-anywhere p-1-0 ${classes.detail}`} data-bar={share !== null || undefined}>
        {share !== null && (
          <Meter thin label={`${name}: ${Math.floor(share * 100)} % here`} whole={1} parts={[{ value: share }]} />
        )}
        <span className="small mid">{detail}</span>
      </span>
      <StatusBadge kind={state} />
      <span className={`flex justify-end ${classes.does}`}>
        {does === 'stop' && uploadId && (
          <Button square variant="quiet" icon="cross" aria-label={`Stop ${name}`} onClick={() => onStop(uploadId)} />
        )}
        {does === 'dismiss' && uploadId && (
          <Button
            square
            variant="quiet"
            icon="cross"
            aria-label={`Remove ${name} from the list`}
            onClick={() => onDismiss(uploadId)}
          />
        )}
        {does === 'recheck' && takeId && (
          <Button
            square
            variant="quiet"
            icon="turn"
            aria-label={`Check ${name} again`}
            onClick={() => onRecheck(takeId)}
          />
        )}
      </span>
    </>
  )
}
