import { useRef, useState } from 'react'

import { post, useMutation } from '@/api'
import { filesOfDrop } from '@/uploads'
import type { Finding } from '@/precheck/findings'
import { FindingLine } from '@/precheck/FindingLine'
import { type Judge, judgeInWorker } from '@/precheck/judgeInWorker'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { StatusBadge } from '@/ui/StatusBadge'

import classes from './Sentences.module.css'

interface Tried {
  name: string
  /** null where only the server can judge the file. */
  findings: Finding[] | null
}

interface TryFileProps {
  projectId: string
  /** What judges a file, away from the page. */
  makeJudge?: () => Judge
}

/** Judge a file in this browser by the saved spec, as the desk does before an upload. */
export function TryFile({ projectId, makeJudge = judgeInWorker }: TryFileProps) {
  const judge = useRef<Judge>(undefined)
  const picker = useRef<HTMLInputElement>(null)
  const [isOver, setOver] = useState(false)
  const trial = useMutation({
    mutationFn: async (file: File): Promise<Tried> => {
      const { files, specs } = await post(
        '/v1/projects/{project_id}/check-preview',
        { project_id: projectId },
        { files: [{ file_name: file.name, cue_id: null }], proposed: [] },
      )
      const preview = files[0]
      const spec = preview && specs[preview.spec]
      if (preview === undefined || spec === undefined) return { name: file.name, findings: null }
      judge.current ??= makeJudge()
      const judgement = await judge.current({ file, spec, length: preview.length })
      if (judgement === null) return { name: file.name, findings: null }
      const ofName = judgement.isUnreadable ? [] : preview.findings
      return { name: file.name, findings: [...judgement.findings, ...ofName] }
    },
  })
  const take = (file: File | undefined) => file && trial.mutate(file)
  return (
    <Card aria-labelledby="try-a-file">
      <CardHead id="try-a-file" title="Try a file" />
      {/* Dropping is a shorter way; the button does the same. */}
      {/* eslint-disable-next-line jsx-a11y/no-static-element-interactions */}
      <div
        className={`inset rounded ${classes.try}`}
        data-over={isOver || undefined}
        onDragOver={(event) => {
          event.preventDefault()
          setOver(true)
        }}
        onDragLeave={() => setOver(false)}
        onDrop={(event) => {
          event.preventDefault()
          setOver(false)
          void filesOfDrop(event.dataTransfer).then(([picked]) => take(picked?.file))
        }}
      >
        <div aria-live="polite" className="grid justify-items-start gap-1">
          {trial.data && <Outcome tried={trial.data} />}
        </div>
        <Refusal error={trial.error} />
        <Button icon="upload" aria-busy={trial.isPending} onClick={() => picker.current?.click()}>
          {trial.data ? 'Another file' : 'Choose file'}
        </Button>
        <input
          ref={picker}
          type="file"
          hidden
          aria-label="File to try"
          onChange={({ currentTarget }) => {
            take(currentTarget.files?.[0])
            currentTarget.value = ''
          }}
        />
        <p className="small mid">Drop any file here. It is not delivered.</p>
      </div>
    </Card>
  )
}

function Outcome({ tried: { name, findings } }: { tried: Tried }) {
  if (findings === null) {
    return (
      <>
        <p className="mono">{name}</p>
        <p className="mid">This file cannot be judged in the browser. The server checks it after the upload.</p>
      </>
    )
  }
  const errors = findings.filter(({ severity }) => severity === 'error').length
  return (
    <>
      <p className="mono">{name}</p>
      {errors > 0 ? (
        <StatusBadge kind="returned">Would be sent back</StatusBadge>
      ) : (
        <StatusBadge kind="passed">Accepted</StatusBadge>
      )}
      {findings.map((finding) => (
        <FindingLine key={`${finding.code} ${finding.start_s ?? ''}`} finding={finding} />
      ))}
      <p className="small mid">
        Format, levels and the name are checked here; the server looks further into the sound.
      </p>
    </>
  )
}
