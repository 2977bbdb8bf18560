import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import type { Player } from '@/audio'
import { loadSplitPanel, splitsQuery } from '@/splitting'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { StatusBadge } from '@/ui/StatusBadge'
import { useLazy } from '@/ui/useLazy'

import { useSounds } from './api'
import { hear } from './ReturnedTakesCard'
import classes from './Unmatched.module.css'

/** Files that hold several sounds: each is split into variations if its designer wants that. */
export function SeveralSounds({ projectId, player }: { projectId: string; player: Player }) {
  const { data: offers = [] } = useQuery(splitsQuery(projectId))
  const [openId, setOpenId] = useState<string | null>(null)
  if (offers.length === 0) return null
  return (
    <section aria-label="Files with several sounds">
      <div className={`flex wrap items-center gap-2-3 ${classes.bar}`}>
        <StatusBadge kind="question">{plural(offers.length, 'file')} with several sounds</StatusBadge>
        <span className="small mid">Nothing is split until you say so.</span>
      </div>
      {offers.map(({ take_id: id, file_name: name, cue, says }) => (
        <div key={id} className="p-3-inset" role="group" aria-label={name}>
          <div className={`row wrap ${classes.acts}`}>
            <span className="mono wrap-anywhere">{name}</span>
            {cue && (
              <span className="small mid">
                <span className="mono dim">{cue.label}</span> {cue.name}
              </span>
            )}
            <span className="grow" />
            <Button
              pressed={openId === id}
              aria-label={`Split ${name} into variations`}
              onClick={() => setOpenId(openId === id ? null : id)}
            >
              Split into variations…
            </Button>
          </div>
          <p className="small mid">{says}</p>
          {openId === id && (
            <OpenFile projectId={projectId} takeId={id} name={name} cueId={cue?.id ?? null} player={player} />
          )}
        </div>
      ))}
    </section>
  )
}

interface OpenFileProps {
  projectId: string
  takeId: string
  name: string
  cueId: string | null
  player: Player
}

function OpenFile({ projectId, takeId, name, cueId, player }: OpenFileProps) {
  const { data: sounds } = useSounds({ id: takeId, state: 'conforming' })
  const url = sounds?.master.preview_url ?? null
  const SplitPanel = useLazy(loadSplitPanel, true)
  if (SplitPanel === null) return null
  return (
    <SplitPanel
      projectId={projectId}
      takeId={takeId}
      fileName={name}
      cueId={cueId}
      onHear={url === null ? undefined : (fromS) => hear(player, takeId, url, fromS)}
    />
  )
}
