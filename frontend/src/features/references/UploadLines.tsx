import { isGoing, type UploadQueue, useLeaveWarning, useUploads } from '@/uploads'
import { Button } from '@/ui/Button'
import { bytesOf } from '@/ui/format'
import { Meter } from '@/ui/Meter'

import classes from './Board.module.css'

/** Files on their way to the board, and those that were not sent. */
export function UploadLines({ queue }: { queue: UploadQueue }) {
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  if (uploads.length === 0) return null
  return (
    <ul className={`grid gap-1 ${classes.uploads}`} aria-label="Uploads">
      {uploads.map((upload) => {
        const { id, file, state, sentBytes, reason } = upload
        const going = isGoing(upload)
        return (
          <li key={id}>
            <span className="mono nowrap overflow-hidden text-ellipsis">{file.name}</span>
            {going ? (
              <>
                <Meter thin label={file.name} whole={Math.max(1, file.size)} parts={[{ value: sentBytes }]} />
                <span className="small dim">
                  {state === 'line_lost'
                    ? 'Connection lost. Upload resumes automatically.'
                    : bytesOf(sentBytes, file.size)}
                </span>
              </>
            ) : (
              <span className="small tone-bad toned">
                {state === 'already_here' ? 'This file is on its way already.' : (reason ?? 'Stopped.')}
              </span>
            )}
            <Button
              square
              variant="quiet"
              icon="cross"
              aria-label={going ? `Stop ${file.name}` : `Remove ${file.name} from the list`}
              onClick={() => (going ? queue.stop(id) : queue.dismiss(id))}
            />
          </li>
        )
      })}
    </ul>
  )
}
