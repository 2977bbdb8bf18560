import { Textarea } from '@mantine/core'
import { useQuery, useQueryClient } from '@tanstack/react-query'
import { useState } from 'react'

import { put, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { DraftForm } from '@/app/drafts/DraftForm'
import { showToast } from '@/app/toast'
import { type ReasonKind, reasonsQuery, type ReviewReasons } from '@/verdicts/reasons'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Field, Submit } from '@/ui/Form'
import { Refusal } from '@/ui/Refusal'
import { Segmented } from '@/ui/Segmented'

import type { Project } from '../api'
import { linesOf } from '../words'
import classes from './People.module.css'

const KINDS: { value: ReasonKind; label: string }[] = [
  { value: 'change', label: 'Changes' },
  { value: 'pick', label: 'Approvals' },
  { value: 'label', label: 'Labels' },
]
const WHAT: Record<ReasonKind, string> = {
  change: 'Why a change is requested',
  pick: 'Why a version is approved',
  label: 'What an alternate is',
}

/** The studio's lists of reasons and labels, each line on its digit in Review. */
export function ReasonsCard({ project }: { project: Project }) {
  const { data: lists, error } = useQuery(reasonsQuery(project.id))
  const [kind, setKind] = useState<ReasonKind>('change')
  return (
    <Card aria-labelledby="review-reasons">
      <CardHead id="review-reasons" title="Reasons and labels" note="on the digits in Review, for all projects" />
      <Refusal inset error={error} />
      {lists && (
        <div className="grid gap-3 p-3-inset-4">
          <Segmented label="List" options={KINDS} value={kind} onChange={setKind} />
          {project.mine.is_producer ? (
            <ReasonsForm key={kind} project={project} kind={kind} list={lists[kind]} />
          ) : (
            <ol aria-label={WHAT[kind]}>
              {lists[kind].reasons.map((reason, index) => (
                <li key={reason}>
                  <span className="mono dim">{index + 1}</span> {reason}
                </li>
              ))}
            </ol>
          )}
        </div>
      )}
    </Card>
  )
}

interface ReasonsFormProps {
  project: Project
  kind: ReasonKind
  list: ReviewReasons[ReasonKind]
}

function ReasonsForm({ project, kind, list }: ReasonsFormProps) {
  const saved = list.reasons.join('\n')
  const write = useSetReasons(project)
  const save = (reasons: string[], message: string, onSent?: () => void) =>
    write.mutate(
      { [kind]: reasons },
      {
        onSuccess: () => {
          onSent?.()
          showToast(message)
        },
      },
    )
  return (
    <DraftForm
      className={`grid gap-3 ${classes.checklist}`}
      draftKey={`reasons:${project.studio.id}:${kind}:${saved}`}
      initialValues={{ reasons: saved }}
      mutation={write}
      onSubmit={({ reasons }, onSent) => save(linesOf(reasons), `${WHAT[kind]}: the list is saved.`, onSent)}
    >
      {({ reasons }) => (
        <>
          <Field
            as={Textarea}
            optional
            name="reasons"
            label={WHAT[kind]}
            description="One a line, up to nine of 40 letters, in the order of the digits. What was said before stays as it was said."
            rows={9}
          />
          <Submit
            variant="plain"
            disabled={reasons === saved}
            className="row"
            beside={
              list.is_own && (
                <Button onClick={() => save([], `${WHAT[kind]}: ours again.`)} aria-busy={write.isPending}>
                  Reset to defaults
                </Button>
              )
            }
          >
            Save list
          </Submit>
        </>
      )}
    </DraftForm>
  )
}

function useSetReasons(project: Project) {
  const client = useQueryClient()
  return useMutation({
    mutationFn: (body: Partial<Record<ReasonKind, string[]>>) =>
      put('/v1/studios/{studio_id}/review-reasons', { studio_id: project.studio.id }, body),
    onSuccess: (lists) => client.setQueryData(reasonsQuery(project.id).queryKey, lists),
    onSettled: () => invalidate(client, queryKeys.reviewReasons.all),
  })
}
