import { Menu } from '@mantine/core'
import { useQueryClient } from '@tanstack/react-query'
import { useRouter } from '@tanstack/react-router'

import { get, put } from '@/api'
import { invalidate, queryKeys } from '@/api/queryKeys'
import { meQuery } from '@/api/me'
import { showToast } from '@/app/toast'

import { type DemoPart, demoPartOf } from './parts'

const PARTS: { part: DemoPart; label: string }[] = [
  { part: 'producer', label: 'Producer' },
  { part: 'approver', label: 'Approver' },
  { part: 'designer', label: 'Sound designer' },
]

/** Change whom the visitor of the demo plays. */
function usePlayPart(): (part: DemoPart, href?: string) => Promise<void> {
  const client = useQueryClient()
  const router = useRouter()
  return async (part, href = '/') => {
    try {
      await put('/v1/demo/part/{part}', { part })
    } catch {
      showToast('Could not switch roles: the server can’t be reached.')
      return
    }
    // The current page stays until the new one is ready; refetching it as another person would be refused.
    const forget = () => client.removeQueries({ type: 'inactive', fetchStatus: 'idle' })
    forget()
    client.setQueryData(meQuery.queryKey, await get('/v1/me'))
    void invalidate(client, queryKeys.session())
    await router.navigate({ href })
    forget()
    await client.invalidateQueries()
  }
}

/** The demo's menu rows: its three people, and the game's build. */
export function DemoSwitch({ projectId }: { projectId: string | undefined }) {
  const client = useQueryClient()
  const play = usePlayPart()
  const router = useRouter()
  const me = client.getQueryData(meQuery.queryKey)
  const now = me && demoPartOf(me)
  const toBuild = async () => {
    const href = `/projects/${projectId}/builds`
    if (now === 'designer') await play('producer', href)
    else await router.navigate({ href })
  }
  return (
    <>
      <Menu.Label>View the demo as</Menu.Label>
      <Menu.RadioGroup value={now ?? null} onChange={(part) => void play(part as DemoPart)}>
        {PARTS.map(({ part, label }) => (
          <Menu.RadioItem key={part} value={part} closeMenuOnClick>
            {label}
          </Menu.RadioItem>
        ))}
      </Menu.RadioGroup>
      {projectId && <Menu.Item onClick={() => void toBuild()}>Build: what the game’s CI runs</Menu.Item>}
      <Menu.Divider />
    </>
  )
}
