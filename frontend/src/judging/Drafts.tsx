import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { ApiProblem } from '@/api'
import { HotkeyButton } from '@/app/keys'
import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { ProblemNote } from '@/ui/ProblemNote'

import { type ChangeRequest, draftsQuery, type Sending, useDropDraft, useSending } from './api'
import classes from './Drafts.module.css'
import { variationName } from './hearing'
import { namesOf, sentence, spot } from './words'

interface DraftsProps {
  projectId: string
  /** Whether the person at the screen may drop and send them. */
  mayDecide: boolean
}

/** How many changes are noted and not sent. */
export function useDraftCount(projectId: string): number {
  return useQuery(draftsQuery(projectId)).data?.length ?? 0
}

/** Changes that are noted, and the one button that sends them all. */
export function Drafts({ projectId, mayDecide }: DraftsProps) {
  const { data: drafts = [] } = useQuery(draftsQuery(projectId))
  const dropping = useDropDraft(projectId)
  const sending = useSending(projectId)
  const [asking, setAsking] = useState(false)
  const [note, setNote] = useState('')

  const send = () =>
    sending.mutate(note.trim(), {
      onSuccess: (sent) => {
        setAsking(false)
        setNote('')
        showToast(`${plural(sent.change_requests.length, 'change')} sent.`)
      },
    })
  const problem = [dropping.error, sending.error].find((error) => error instanceof ApiProblem)

  return (
    <>
      <ul aria-label="Changes that are not sent">
        {drafts.map((draft) => (
          <DraftLine
            key={draft.id}
            draft={draft}
            heldBack={sending.data?.held_back.find((held) => held.change_request_id === draft.id)?.why}
            onDrop={mayDecide ? () => dropping.mutate(draft) : undefined}
          />
        ))}
      </ul>
      {mayDecide && drafts.length > 0 && (
        <div className={classes.foot}>
          {asking && (
            <>
              <p className="small mid">{roundsOf(drafts)} What was sent cannot be taken back.</p>
              <input
                className={classes.note}
                aria-label="A word that goes with all of them"
                placeholder="A word that goes with all of them"
                maxLength={10_000}
                value={note}
                onChange={(event) => setNote(event.currentTarget.value)}
                onKeyDown={(event) => {
                  if (event.key === 'Enter' && !event.nativeEvent.isComposing) send()
                }}
              />
              <Button onClick={() => setAsking(false)}>Not yet</Button>
            </>
          )}
          {asking ? (
            <Button variant="primary" icon="upload" disabled={sending.isPending} onClick={send}>
              Send {plural(drafts.length, 'change')} to the designer
            </Button>
          ) : (
            <HotkeyButton icon="upload" keys="s" keyLabel="Send the noted changes" onPress={() => setAsking(true)}>
              Send {plural(drafts.length, 'change')}
            </HotkeyButton>
          )}
        </div>
      )}
      {problem && <ProblemNote detail={problem.detail} fix={problem.fix} />}
      {sending.data && sending.data.held_back.length > 0 && (
        <ProblemNote detail={heldBackWords(sending.data)} fix="They stay here as drafts." />
      )}
    </>
  )
}

function DraftLine({ draft, heldBack, onDrop }: { draft: ChangeRequest; heldBack?: string; onDrop?: () => void }) {
  const where = spot(draft.start_s, draft.end_s)
  const name = draft.variation > 1 ? `${draft.cue_name} ${variationName(draft.variation)}` : draft.cue_name
  return (
    <li className={classes.row}>
      <span className="cut-text">
        <span className="strong">{name}</span> <span className="small dim">version {draft.number}</span>
      </span>
      {where && <span className="mono small dim nowrap">{where}</span>}
      <p className="mid">{draft.text}</p>
      {heldBack && <p className="small">{sentence(heldBack)}</p>}
      {onDrop && (
        <Button variant="quiet" className="small" aria-label={`Drop the change to ${name}`} onClick={onDrop}>
          Drop
        </Button>
      )}
    </li>
  )
}

function roundsOf(drafts: readonly ChangeRequest[]): string {
  const counted = drafts.filter(({ reverses }) => !reverses).map(({ cue_name }) => cue_name)
  const cues = new Set(counted).size
  if (cues === 0) return 'They reverse approvals, so no round counts.'
  return cues === 1 ? `It counts one round for ${counted[0]}.` : `It counts one round each for ${namesOf(counted)}.`
}

const heldBackWords = (sent: Sending): string =>
  `${plural(sent.held_back.length, 'change')} could not go out: ${namesOf(sent.held_back.map(({ why }) => why))}.`
