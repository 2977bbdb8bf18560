import { useQueryClient } from '@tanstack/react-query'
import { useNavigate } from '@tanstack/react-router'
import type { ReactNode } from 'react'

import { del, post, useMutation } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'

import classes from './SampleProject.module.css'
import { showToast } from './toast'

/** Opens the sample project of a studio, which the server makes where there is none. */
export function useOpenSample(studioId: string) {
  const client = useQueryClient()
  const navigate = useNavigate()
  return useMutation({
    mutationFn: () => post('/v1/studios/{studio_id}/sample', { studio_id: studioId }),
    onSuccess: async ({ id: projectId }) => {
      await invalidate(client, queryKeys.me(), queryKeys.projects.all)
      await navigate({ to: '/projects/$projectId/sound-list', params: { projectId } })
    },
  })
}

/** The offer to look around first. */
export function SampleOffer({ studioId }: { studioId: string }): ReactNode {
  const open = useOpenSample(studioId)
  return (
    <aside className={`rounded ${classes.offer}`} aria-label="Sample project">
      <span className="mid">Look first? The sample has 24 sounds, a brief and a delivery to review.</span>
      <Button aria-busy={open.isPending} onClick={() => open.mutate()}>
        Open sample
      </Button>
      <Refusal error={open.error} />
    </aside>
  )
}

/** Says on every page that this is the sample, and deletes it. */
export function SampleBanner({ projectId, isProducer }: { projectId: string; isProducer: boolean }): ReactNode {
  const client = useQueryClient()
  const navigate = useNavigate()
  const remove = useMutation({
    mutationFn: () => del('/v1/projects/{project_id}/sample', { project_id: projectId }),
    onSuccess: async () => {
      await navigate({ to: '/projects' })
      showToast('Sample project deleted.')
      await invalidate(client, queryKeys.me(), queryKeys.projects.all)
    },
  })
  return (
    <aside className={`bg-well border-b ${classes.banner}`} aria-label="Sample project">
      <span>This is the sample project. Try everything, and delete it when you are done.</span>
      {isProducer && (
        <Button aria-busy={remove.isPending} onClick={() => remove.mutate()}>
          Delete sample
        </Button>
      )}
      <Refusal error={remove.error} />
    </aside>
  )
}
