import { useEffect, useEffectEvent, useId, useRef, useState } from 'react'

import { base64Of } from '@/api/base64'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { bytes, plural } from '@/ui/format'

import type { Contract } from './api'
import classes from './Contracts.module.css'
import { type RedlineDraft, withRead } from './redlineDraft'
import { useReadWord } from './redlines'
import styles from './Redlines.module.css'
import { Warning } from './Warning'

const LARGEST_BYTES = 6_000_000
const ACCEPTED = '.docx,application/vnd.openxmlformats-officedocument.wordprocessingml.document'

interface WordUploadProps {
  contract: Contract
  draft: RedlineDraft
  onDraft: (next: (now: RedlineDraft) => RedlineDraft) => void
}

/** The field for a Word document that comes back: its changes are added to the draft, and nothing is sent. */
export function WordUpload({ contract, draft, onDraft }: WordUploadProps) {
  const headId = useId()
  const field = useRef<HTMLElement>(null)
  const picker = useRef<HTMLInputElement>(null)
  const [isOver, setIsOver] = useState(false)
  const [unread, setUnread] = useState<string | null>(null)
  const read = useReadWord(contract.id)
  const take = async (file: File | undefined) => {
    if (!file || read.isPending) return
    read.reset()
    setUnread(null)
    if (file.size > LARGEST_BYTES) {
      setUnread(`${file.name} has ${bytes(file.size)}; the limit is ${bytes(LARGEST_BYTES)}. Remove its pictures.`)
      return
    }
    try {
      const content = await base64Of(file)
      read.mutate(content, { onSuccess: (found) => onDraft((now) => withRead(now, contract, file.name, found)) })
    } catch {
      setUnread(`${file.name} could not be read from your disk. Choose it again.`)
    }
  }
  const takeDropped = useEffectEvent((dropped: File | undefined) => void take(dropped))
  useEffect(() => {
    const element = field.current
    if (!element) return
    const enter = (event: DragEvent) => {
      event.preventDefault()
      setIsOver(true)
    }
    const leave = () => setIsOver(false)
    const drop = (event: DragEvent) => {
      event.preventDefault()
      setIsOver(false)
      takeDropped(event.dataTransfer?.files[0])
    }
    element.addEventListener('dragover', enter)
    element.addEventListener('dragleave', leave)
    element.addEventListener('drop', drop)
    return () => {
      element.removeEventListener('dragover', enter)
      element.removeEventListener('dragleave', leave)
      element.removeEventListener('drop', drop)
    }
  }, [])
  const file = `/v1/contracts/${contract.id}/versions/${contract.version.number}/contract.docx`
  return (
    <section
      ref={field}
      aria-labelledby={headId}
      aria-busy={read.isPending}
      className={`grid grid-cols-1 gap-2 p-3-4 border rounded-l ${styles.word}`}
      data-over={isOver || undefined}
    >
      <h3 id={headId}>Word document</h3>
      <p className="small mid">
        Take the text out, edit it in Word with or without tracked changes, and upload it here. Its changes are added
        below for you to look at. Nothing is sent until you send it.
      </p>
      <div className={classes.buttons}>
        <Button icon="upload" aria-busy={read.isPending} onClick={() => picker.current?.click()}>
          Upload a Word document
        </Button>
        <a className="link" href={file} download>
          {`Take version ${contract.version.number} out as Word`}
        </a>
      </div>
      <input
        ref={picker}
        type="file"
        accept={ACCEPTED}
        hidden
        aria-label="Word document"
        onChange={({ currentTarget }) => {
          void take(currentTarget.files?.[0])
          currentTarget.value = ''
        }}
      />
      {unread !== null && <Warning>{unread}</Warning>}
      <Refusal error={read.error} />
      <div role="status">
        {draft.read && (
          <div className={`grid grid-cols-1 gap-2 wrap-anywhere ${styles.found}`}>
            <p>
              <strong>{draft.read.file}</strong>
              {` ${draft.read.added === 0 ? 'No change was found.' : `${plural(draft.read.added, 'change')} added below.`}`}
            </p>
            {draft.read.findings.length > 0 && (
              <>
                <p className="mid">{`${plural(draft.read.findings.length, 'thing')} to look at:`}</p>
                <ul>
                  {draft.read.findings.map(({ message, fix }) => (
                    <li key={message}>
                      {message} <span className="mid">{fix}</span>
                    </li>
                  ))}
                </ul>
              </>
            )}
            <div>
              <Button
                variant="quiet"
                icon="cross"
                onClick={() => onDraft(({ changes, note, version }) => ({ changes, note, version }))}
              >
                Close this report
              </Button>
            </div>
          </div>
        )}
      </div>
    </section>
  )
}
