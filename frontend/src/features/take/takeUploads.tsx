import { useEffect, useState } from 'react'

import { Button } from '@/ui/Button'
import { bytesOf } from '@/ui/format'
import { Meter } from '@/ui/Meter'
import {
  type Accepts,
  partsTransport,
  tusTransport,
  type Upload,
  UploadQueue,
  useLeaveWarning,
  useUploads,
} from '@/uploads'

import type { Take } from './api'
import classes from './Take.module.css'

/** The upload queue of a version; `onFinished` gives the version each file that has arrived. */
export function useTakeUploads(take: Take, accepts: Accepts, onFinished: (uploadId: string) => Promise<void>) {
  const [queue] = useState(() => {
    const where = {
      endpoint: '/v1/uploads',
      metadata: ({ file }: Upload) => ({ delivery_id: take.delivery_id, take_id: take.id, file_name: file.name }),
    }
    return new UploadQueue({
      accepts,
      atATime: 1,
      transport: partsTransport({ ...where, otherwise: tusTransport(where) }),
      onFinished: (_, uploadId) => onFinished(uploadId),
    })
  })
  useEffect(() => () => queue.dispose(), [queue])
  const { uploads } = useUploads(queue)
  useLeaveWarning(uploads)
  return { queue, uploads }
}

/** How much of a file is here, and the button that stops it. */
export function UploadProgress({ upload, onStop }: { upload: Upload; onStop: () => void }) {
  const { file, sentBytes, state } = upload
  const share = file.size > 0 ? sentBytes / file.size : 0
  const here = bytesOf(sentBytes, file.size)
  return (
    <>
      <span className={classes.stemBar}>
        <Meter thin label={`${file.name}: ${Math.floor(share * 100)} % here`} whole={1} parts={[{ value: share }]} />
      </span>
      <span className="small mid">
        {state === 'line_lost' ? `Connection lost at ${here}. The upload resumes by itself.` : here}
      </span>
      <Button square variant="quiet" icon="cross" aria-label={`Stop ${file.name}`} onClick={onStop} />
    </>
  )
}
