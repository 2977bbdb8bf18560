import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { type ReactNode, useEffect, useId, useMemo, useState, useSyncExternalStore } from 'react'

import { ApiProblem } from '@/api'
import { keepDraft, useDraft } from '@/app/drafts'
import { HotkeyButton } from '@/app/keys'
import { showToast } from '@/app/toast'
import { ended } from '@/verdicts/findings'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { FieldError } from '@/ui/FieldError'
import { Refusal } from '@/ui/Refusal'
import { bytesOf, plural, remaining } from '@/ui/format'
import { isGoing, useLeaveWarning, useUploads } from '@/uploads'

import { type Delivery, openDeliveryQuery, useCloseDelivery, useDelivery, useRecheck, useSaveNote } from './api'
import classes from './Delivery.module.css'
import { DeliveryLines } from './DeliveryLines'
import { DeliverySources } from './DeliverySources'
import type { DeliveryUploads } from './deliveryUploads'
import { type DeliveryRows, type LabelOf, receivedRows, refusedNameOf, refusedRows, rowsOf } from './rows'

interface DeliveryCardProps {
  projectId: string
  uploads: DeliveryUploads
  labelOf: LabelOf
  onChoose: () => void
  onChooseFolder: () => void
  /** Why the files could not be taken at all. */
  problem: unknown
  /** What would come back, before it is sent. */
  held: ReactNode
  /** What waits for its cue. */
  children: ReactNode
}

/** Where files go in: what is on its way, what happened to it, and the note that goes with it. */
export function DeliveryCard({
  projectId,
  uploads,
  labelOf,
  onChoose,
  onChooseFolder,
  problem,
  held,
  children,
}: DeliveryCardProps) {
  const { queue } = uploads
  const sending = useUploads(queue)
  const { data: delivery } = useQuery(openDeliveryQuery(projectId))
  const { data: detail } = useDelivery(delivery?.id)
  const recheck = useRecheck(projectId)
  useLeaveWarning(sending.uploads)
  const received = useMemo(() => (detail ? receivedRows(detail) : []), [detail])
  const refusedEarlier = useSyncExternalStore(uploads.refused.subscribe, uploads.refused.get)
  const notSent = useMemo(() => refusedRows(refusedEarlier), [refusedEarlier])
  const rows = rowsOf(sending.uploads, [...notSent, ...received], uploads.takeOf, labelOf)
  const going = sending.uploads.some(isGoing)
  const empty = rows.open.length + rows.done.length === 0
  const refused = problem ?? recheck.error

  return (
    <Card aria-labelledby="delivery">
      <CardHead
        id="delivery"
        title={delivery ? `Delivery ${delivery.number}` : 'Deliver'}
        note={<span role="status">{sumsOf(sending.figures, going, rows)}</span>}
        end={
          <>
            {!empty && <span className="wide-only">drop files, folders or a ZIP anywhere</span>}
            <Link className="link small" to="/projects/$projectId/deliveries" params={{ projectId }}>
              All deliveries
            </Link>
            {going && (
              <Button
                variant="quiet"
                icon={sending.paused ? 'play' : 'pause'}
                onClick={() => (sending.paused ? queue.resume() : queue.pause())}
              >
                {sending.paused ? 'Resume' : 'Pause'}
              </Button>
            )}
            {!empty && (
              <>
                <Button variant="quiet" onClick={onChooseFolder}>
                  Folder
                </Button>
                <HotkeyButton icon="upload" keys="n" keyLabel="Deliver files" keyGroup="Desk" onPress={onChoose}>
                  Choose files
                </HotkeyButton>
              </>
            )}
          </>
        }
      />
      {refused !== null && (
        <div className="p-3-inset">
          <Refusal error={refused} />
        </div>
      )}
      {held}
      {empty && (
        <div className={`flex wrap items-center between p-inset rounded ${classes.drop}`}>
          <p>
            <span className="strong">Drop files, a folder or a ZIP anywhere on this page.</span>{' '}
            <span className="mid">
              Files are matched to cues by name. Files that match no cue wait here until you choose one. A file named{' '}
              <span className="mono">…__dry.wav</span> is not a version: it is added as the dry stem of the version with
              that name. Uploads resume if you lose your connection.
            </span>
          </p>
          <span className={`flex wrap gap-2 narrow-w-full ${classes.choose}`}>
            <HotkeyButton
              variant="primary"
              icon="upload"
              keys="n"
              keyLabel="Deliver files"
              keyGroup="Desk"
              onPress={onChoose}
            >
              Choose files
            </HotkeyButton>
            <Button onClick={onChooseFolder}>Choose folder</Button>
          </span>
        </div>
      )}
      <DeliveryLines
        rows={rows}
        onStop={(id) => queue.stop(id)}
        onDismiss={(id) => {
          const name = refusedNameOf(id)
          if (name === null) queue.dismiss(id)
          else uploads.forgetRefused(name)
        }}
        onRecheck={(takeId) => recheck.mutate(takeId)}
      />
      {children}
      {delivery && <DeliverySources key={`sources ${delivery.id}`} deliveryId={delivery.id} number={delivery.number} />}
      {delivery && <Foot key={delivery.id} projectId={projectId} delivery={delivery} going={going} />}
    </Card>
  )
}

function sumsOf(
  figures: { sentBytes: number; totalBytes: number; secondsLeft: number | null },
  going: boolean,
  { open, done }: DeliveryRows,
): string {
  const checking = open.filter(({ state }) => state === 'checking').length
  const parts = [
    going ? bytesOf(figures.sentBytes, figures.totalBytes) : '',
    going && figures.secondsLeft !== null ? `${remaining(figures.secondsLeft)} left` : '',
    checking > 0 ? `${checking} being checked` : '',
    !going && done.length + open.length > 0 ? plural(done.length + open.length, 'file') : '',
  ]
  return parts.filter(Boolean).join(', ')
}

function Foot({ projectId, delivery, going }: { projectId: string; delivery: Delivery; going: boolean }) {
  const draftKey = `delivery:${delivery.id}`
  const [note, setNote] = useDraft(draftKey, delivery.note)
  const save = useSaveNote(projectId)
  const close = useCloseDelivery(projectId)
  const [asked, setAsked] = useState(false)
  useEffect(() => {
    if (!going) setAsked(false)
  }, [going])
  const noteId = useId()
  const keep = async () => {
    if (note.trim() === delivery.note) return
    await save.mutateAsync({ deliveryId: delivery.id, note: note.trim() })
    keepDraft(draftKey, null)
  }
  const finish = async () => {
    if (going && !asked) {
      setAsked(true)
      return
    }
    try {
      await keep()
      await close.mutateAsync(delivery.id)
      showToast(`Delivery ${delivery.number} closed. The next file starts a new delivery.`)
    } catch {
      // The refusal stands below the field.
    }
  }
  const error = save.error ?? close.error
  return (
    <form
      className={`flex wrap items-end gap-2-4 border-t ${classes.foot}`}
      onSubmit={(event) => {
        event.preventDefault()
        void keep().catch(() => undefined)
      }}
    >
      <div className={`grow grid gap-1 ${classes.note}`}>
        <label htmlFor={noteId}>Note on delivery {delivery.number}</label>
        <input
          id={noteId}
          className="line-field"
          placeholder="What is in it and what to listen for"
          aria-invalid={error instanceof ApiProblem || undefined}
          aria-describedby={`${noteId}-below`}
          value={note}
          onChange={(event) => setNote(event.currentTarget.value)}
          onBlur={() => void keep().catch(() => undefined)}
        />
        <div id={`${noteId}-below`}>
          {save.isSuccess && note.trim() === delivery.note && <span className="small dim">Saved.</span>}
          {error instanceof ApiProblem && <FieldError>{ended(error.detail)}</FieldError>}
        </div>
      </div>
      <Button onClick={() => void finish()}>
        {asked ? 'Close it; later files are marked late' : 'Close delivery'}
      </Button>
    </form>
  )
}
