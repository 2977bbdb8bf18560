import { useMutation } from '@/api'
import { useId, useState } from 'react'

import { useTitle } from '@/app/title'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { clock, day } from '@/ui/format'
import { PageHead } from '@/ui/PageHead'
import { StatusBadge, type StateKind } from '@/ui/StatusBadge'

import { type Verified, verifyPdf } from './api'
import classes from './Contracts.module.css'
import { KIND_WORDS } from './words'

const VERDICTS: Record<Verified['verdict'], { kind: StateKind; text: string; meaning: string }> = {
  untouched: {
    kind: 'accepted',
    text: 'Untouched',
    meaning: 'Every byte is as it was when this server sealed it.',
  },
  changed: {
    kind: 'returned',
    text: 'Changed',
    meaning: 'It was sealed by this server, and is not the file that was sealed. Ask for the original.',
  },
  not_ours: {
    kind: 'waiting',
    text: 'Not sealed here',
    meaning:
      'This server has not sealed this file. It may be from another server, or a PDF from before everyone signed.',
  },
}

/** For anyone: whether a PDF is a contract that was signed and sealed here, and what it binds. */
export function VerifyPage() {
  useTitle('Verify a contract')
  const inputId = useId()
  const [name, setName] = useState('')
  const { mutate, data, error, isPending } = useMutation({ mutationFn: verifyPdf })
  const take = (files: FileList | null) => {
    const file = files?.[0]
    if (!file || isPending) return
    setName(file.name)
    mutate(file)
  }
  return (
    <div className="page stack">
      <PageHead title="Verify a contract">
        Choose the PDF of a signed contract to see whether it is unchanged and what it binds. The file is compared and
        not kept.
      </PageHead>
      <Card aria-label="The PDF">
        <div className={classes.form}>
          <label htmlFor={inputId} className="strong">
            PDF of the contract, up to 8 MiB
          </label>
          <input
            id={inputId}
            type="file"
            accept="application/pdf,.pdf"
            onChange={({ currentTarget }) => {
              take(currentTarget.files)
              currentTarget.value = ''
            }}
          />
        </div>
      </Card>
      <div role="status" aria-busy={isPending}>
        {isPending && <p className="mid">{`Reading ${name}`}</p>}
        {!isPending && data && <Result verified={data} name={name} />}
      </div>
      <Refusal error={error} />
    </div>
  )
}

function Result({ verified, name }: { verified: Verified; name: string }) {
  const { kind, text, meaning } = VERDICTS[verified.verdict]
  const { binds } = verified
  return (
    <Card aria-labelledby="verdict">
      <CardHead id="verdict" title={name} />
      <div className={classes.form}>
        <div>
          <StatusBadge kind={kind} pill>
            {text}
          </StatusBadge>
        </div>
        <p>{meaning}</p>
        {binds && (
          <dl className={`flex wrap gap-2px-4 ${classes.facts} flex-col`}>
            <Fact name="Contract" value={`${binds.title} (${KIND_WORDS[binds.kind]}, version ${binds.version})`} />
            <Fact name="Between" value={`${binds.studio_name} and ${binds.designer_name}`} />
            {binds.signatures.map(({ party, name: signer, signed_at: at }) => (
              <Fact
                key={`${party} ${signer} ${at}`}
                name={`Signed for the ${party}`}
                value={`${signer}, ${day(at)}, ${clock(at)}`}
              />
            ))}
            <Fact
              name="Sealed"
              value={`${day(binds.sealed_at)}, ${clock(binds.sealed_at)}${binds.is_timestamped ? ', with a timestamp' : ''}`}
            />
            <Fact name="SHA-256 of the text" value={binds.text_sha256} isHash />
          </dl>
        )}
        <p className={`mono dim ${classes.hash}`}>{`SHA-256 of the file ${verified.file_sha256}`}</p>
      </div>
    </Card>
  )
}

function Fact({ name, value, isHash = false }: { name: string; value: string; isHash?: boolean }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd className={isHash ? `mono ${classes.hash}` : undefined}>{value}</dd>
    </div>
  )
}
