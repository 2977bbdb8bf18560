import { TextInput } from '@mantine/core'
import { type FormEvent, type ReactNode, useId, useState } from 'react'

import { ApiProblem } from '@/api'
import { DraftNote, useDraft, useUnsent } from '@/app/drafts'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { clock } from '@/ui/format'

import { useSigningCode } from './api'
import classes from './Contracts.module.css'
import { DrawName } from './DrawnName'
import type { Strokes } from './strokes'
import { Warning } from './Warning'

const CONSENT = 'I have read this text, I agree to be bound by it, and the name that I type is my signature.'
const isCodeNeeded = (error: unknown) => error instanceof ApiProblem && error.code === 'signing-code-needed'

/** Letters that the fonts of PDFs lack: those of other scripts than Latin, Greek and Cyrillic. */
const UNDRAWN = /[^\p{Script=Latin}\p{Script=Greek}\p{Script=Cyrillic}\p{Script=Common}\p{Script=Inherited}]/u

/** What a person signs with: their name, typed and perhaps drawn, and the code where the server mailed one to them. */
export interface Signed {
  name: string
  code: string | null
  drawing: Strokes | null
}

/** Sign a text by typing one's name; where the server sends mail, a code is mailed first and typed here. */
export function SignForm({
  contractId,
  textSha256,
  label,
  button,
  before = [],
  children,
  onSign,
}: {
  contractId: string
  textSha256: string
  label: string
  button: string
  /** Drafts that a signature would leave behind: they are sent or discarded first. */
  before?: readonly { key: string; says: string }[]
  children?: ReactNode
  onSign: (signed: Signed) => Promise<unknown>
}) {
  const [name, setName, draft] = useDraft(`signature:${contractId}:${textSha256}`, '')
  const [code, setCode] = useState('')
  const [strokes, setStrokes] = useState<Strokes>([])
  const [error, setError] = useState<unknown>(null)
  const [isSigning, setSigning] = useState(false)
  const mailed = useSigningCode(contractId)
  const unsent = useUnsent(before.map(({ key }) => key))
  const codeId = useId()
  const askForCode = () =>
    mailed.mutate(textSha256, {
      onSuccess: () => {
        setCode('')
        setError(null)
        requestAnimationFrame(() => document.getElementById(codeId)?.focus())
      },
    })
  const sign = async (event: FormEvent) => {
    event.preventDefault()
    if (isSigning || mailed.isPending || name.trim() === '' || unsent !== null) return
    setSigning(true)
    setError(null)
    try {
      await onSign({
        name: name.trim(),
        code: code.trim() === '' ? null : code.trim(),
        drawing: strokes.length === 0 ? null : strokes,
      })
      draft.discard()
    } catch (refused) {
      if (isCodeNeeded(refused) && !mailed.data) askForCode()
      else setError(refused)
    } finally {
      setSigning(false)
    }
  }
  return (
    <form onSubmit={(event) => void sign(event)} className={classes.inner} aria-label={label}>
      {children}
      <p className="small mid">{`${CONSENT} Recorded with it: your email, the time, your IP address and your browser.`}</p>
      <TextInput
        label="Your full name"
        autoComplete="name"
        value={name}
        maxLength={120}
        onChange={({ currentTarget }) => setName(currentTarget.value)}
      />
      {UNDRAWN.test(name) && (
        <Warning>
          The PDF’s fonts have Latin, Greek and Cyrillic letters only. The audit trail keeps your name as typed; the PDF
          says that it could not draw it.
        </Warning>
      )}
      <DraftNote draft={draft} />
      <DrawName strokes={strokes} onChange={setStrokes} />
      {mailed.data && (
        <>
          <TextInput
            id={codeId}
            label="Code"
            description={`Mailed to ${mailed.data.email}; it works until ${clock(mailed.data.expires_at)} or later, if the mail takes long.`}
            autoComplete="one-time-code"
            inputMode="numeric"
            value={code}
            maxLength={20}
            onChange={({ currentTarget }) => setCode(currentTarget.value)}
          />
          <div>
            <Button variant="quiet" aria-busy={mailed.isPending} onClick={askForCode}>
              Resend code
            </Button>
          </div>
        </>
      )}
      {unsent !== null && <Warning>{before.find(({ key }) => key === unsent)?.says}</Warning>}
      <Refusal error={error ?? mailed.error} />
      <Button
        type="submit"
        variant="primary"
        icon="tick"
        disabled={name.trim() === '' || unsent !== null}
        aria-busy={isSigning || mailed.isPending}
      >
        {button}
      </Button>
    </form>
  )
}
