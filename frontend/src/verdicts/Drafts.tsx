import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { useDraft } from '@/app/drafts'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { ErrorBanner } from '@/ui/ErrorBanner'
import { useFocusOnMount } from '@/ui/useFocusOnMount'

import { type ChangeRequest, draftsQuery, type Sending, useDropDraft, useSendFeedback } from './api'
import classes from './Drafts.module.css'
import { variationName } from './hearing'
import { ReversalNote } from './ReversalNote'
import { SendField } from './SendField'
import { namesOf, sentence, spot } from './words'

interface DraftsProps {
  projectId: string
  /** Whether the current person may drop and send them. */
  mayApprove: boolean
  /** Before the message is asked for: brings the drafts into sight. */
  onAsk?: () => void
}

/** How many changes are drafts that no one sends but their approver. */
export function useDraftCount(projectId: string): number {
  return useQuery(draftsQuery(projectId)).data?.length ?? 0
}

/** Change requests that were kept as drafts, by another program or because they could not be sent; one button sends them all. */
export function Drafts({ projectId, mayApprove, onAsk }: DraftsProps) {
  const { data: drafts = [] } = useQuery(draftsQuery(projectId))
  const dropping = useDropDraft(projectId)
  const sending = useSendFeedback(projectId)
  const [asking, setAsking] = useState(false)
  const [note, setNote, draft] = useDraft(`sending:${projectId}`, '')
  const field = useFocusOnMount<HTMLTextAreaElement>(asking)
  const ask = () => {
    onAsk?.()
    setAsking(true)
  }

  const send = () =>
    sending.mutate(note.trim(), {
      onSuccess: (sent) => {
        setAsking(false)
        draft.discard()
        showToast(`${plural(sent.change_requests.length, 'change')} sent.`)
      },
    })

  return (
    <>
      <ul aria-label="Draft change requests">
        {drafts.map((draft) => (
          <DraftLine
            key={draft.id}
            draft={draft}
            heldBack={sending.data?.held_back.find((held) => held.change_request_id === draft.id)?.why}
            onDrop={mayApprove ? () => dropping.mutate(draft) : undefined}
          />
        ))}
      </ul>
      {mayApprove && drafts.length > 0 && (
        <div className={`grid gap-2 border-t p-3-4 sticky bottom-0 bg-surface ${classes.foot}`}>
          {asking && (
            <>
              <p className="small mid">{roundsOf(drafts)} You can’t undo sending.</p>
              {drafts
                .filter(({ reverses }) => reverses)
                .map((item) => (
                  <ReversalNote key={item.id} cueId={item.cue_id} what={`${nameOf(item)} version ${item.number}`} />
                ))}
              <SendField
                ref={field}
                className={`line-field ${classes.note}`}
                aria-label="Message to the designer (optional)"
                placeholder="Message to the designer (optional)"
                value={note}
                onText={setNote}
                onSend={() => {
                  if (!sending.isPending) send()
                }}
                onLeave={() => setAsking(false)}
              />
              <Button onClick={() => setAsking(false)}>Not yet</Button>
            </>
          )}
          {asking ? (
            <Button variant="primary" icon="upload" disabled={sending.isPending} onClick={send}>
              Send {plural(drafts.length, 'change')} to the designer
            </Button>
          ) : (
            <Button icon="upload" onClick={ask}>
              {plural(drafts.length, 'change')} to send
            </Button>
          )}
        </div>
      )}
      <Refusal error={dropping.error ?? sending.error} />
      {sending.data && sending.data.held_back.length > 0 && (
        <ErrorBanner detail={heldBackWords(sending.data)} fix="They stay here as drafts." />
      )}
    </>
  )
}

function DraftLine({ draft, heldBack, onDrop }: { draft: ChangeRequest; heldBack?: string; onDrop?: () => void }) {
  const where = spot(draft.start_s, draft.end_s)
  const name = nameOf(draft)
  return (
    <li className={`grid items-start gap-0-2 grid-cols-1-auto p-2-4 border-b ${classes.row}`}>
      <span className="cut-text">
        <span className="strong">{name}</span> <span className="small dim">version {draft.number}</span>
      </span>
      {where && <span className="mono small dim nowrap">{where}</span>}
      <p className="mid">{draft.text}</p>
      {heldBack && <p className="small">{sentence(heldBack)}</p>}
      {onDrop && (
        <Button variant="quiet" className="small" aria-label={`Delete draft for ${name}`} onClick={onDrop}>
          Delete draft
        </Button>
      )}
    </li>
  )
}

const nameOf = ({ variation, cue_name: name }: ChangeRequest): string =>
  variation > 1 ? `${name} ${variationName(variation)}` : name

function roundsOf(drafts: readonly ChangeRequest[]): string {
  const counted = drafts.filter(({ reverses }) => !reverses).map(({ cue_name }) => cue_name)
  const cues = new Set(counted).size
  if (cues === 0) return 'No round is counted.'
  return cues === 1
    ? `This counts as one round for ${counted[0]}.`
    : `This counts as one round each for ${namesOf(counted)}.`
}

const heldBackWords = (sent: Sending): string =>
  `${plural(sent.held_back.length, 'change')} could not be sent: ${namesOf(sent.held_back.map(({ why }) => why))}.`
