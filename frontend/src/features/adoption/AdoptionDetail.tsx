import { useQuery, useQueryClient } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { useMutation } from '@/api'
import { showToast } from '@/app/toast'
import { Button, ButtonLink } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'
import { Meter } from '@/ui/Meter'

import { adoptFolder, type Progress, progressQuery, refreshAdopted, sentPlanQuery, useUndoAdoption } from './api'
import { at } from './at'
import { PlanCard } from './PlanCard'

interface Of {
  projectId: string
  adoptionId: string
}

/** A folder that was sent: to adopt, or adopted, with how far its checks are. */
export function AdoptionDetail({ projectId, adoptionId }: Of): ReactNode {
  const { data, error } = useQuery(progressQuery(adoptionId))
  if (error) return <Refusal error={error} />
  if (data === undefined) return null
  if (data.adopted_at === null) return <Sent projectId={projectId} adoptionId={adoptionId} />
  return <Adopted projectId={projectId} progress={data} />
}

function Sent({ projectId, adoptionId }: Of) {
  const client = useQueryClient()
  const { data } = useQuery(sentPlanQuery(adoptionId))
  const adopt = useMutation({
    mutationFn: () => adoptFolder(adoptionId),
    onSuccess: async (adoption) => {
      await refreshAdopted(client, projectId)
      showToast(`${plural(adoption.cues, 'cue')} adopted with ${plural(adoption.takes, 'take')}.`)
    },
  })
  if (data === undefined) return null
  const missing = data.missing.length
  return (
    <>
      <Refusal error={adopt.error} />
      <PlanCard
        plan={data.plan}
        action={`Adopt ${plural(data.plan.files, 'file')} of ${data.folder}`}
        onAdopt={() => {
          if (!adopt.isPending) adopt.mutate()
        }}
        waits={missing > 0 ? `${plural(missing, 'file is', 'files are')} not uploaded yet.` : undefined}
      />
    </>
  )
}

function Adopted({ projectId, progress }: { projectId: string; progress: Progress }) {
  const undo = useUndoAdoption(projectId)
  const { takes, checked, conforming, rendered, odd } = progress
  const isUndone = progress.undone_at !== null
  const says = `${checked} of ${plural(takes, 'sound')} checked, ${rendered} with game files`
  return (
    <Card aria-labelledby="adopted">
      <CardHead
        id="adopted"
        title={progress.folder}
        note={`adopted by ${progress.adopted_by?.name ?? ''}, ${at(progress.adopted_at ?? '')}`}
      />
      <div className="grid gap-3 p-3-inset-4">
        <Refusal error={undo.error} />
        {isUndone ? (
          <p>
            Undone {at(progress.undone_at ?? '')}. Its cues left the list; the uploaded files are kept among the
            discarded ones.
          </p>
        ) : (
          <>
            <p role="status">{says}.</p>
            <Meter label={says} whole={Math.max(1, takes)} parts={[{ value: rendered }]} />
            {checked > 0 && (
              <p>
                {conforming} of {checked} conform to the delivery spec
                {odd.length > 0 ? '; these stand out:' : '.'}
              </p>
            )}
            {odd.length > 0 && (
              <ul className="grid gap-1 wrap-anywhere" aria-label="Sounds with findings">
                {odd.map((take) => (
                  <li key={take.take_id}>
                    <Link className="link" to="/takes/$takeId" params={{ takeId: take.take_id }}>
                      {take.label} {take.file_name}
                    </Link>{' '}
                    <span className={take.verdict === 'conforming' ? 'mid' : 'tone-bad toned'}>
                      {take.messages.join('; ')}
                    </span>
                  </li>
                ))}
              </ul>
            )}
            <div className="flex wrap items-center gap-2-3">
              <ButtonLink component={Link} to={`/projects/${projectId}/sound-list`} variant="primary">
                Open the sound list
              </ButtonLink>
              <Button
                onClick={() => {
                  if (!undo.isPending)
                    undo.mutate(progress.id, { onSuccess: () => showToast('The adoption is undone.') })
                }}
              >
                Undo the adoption
              </Button>
            </div>
          </>
        )}
      </div>
    </Card>
  )
}
