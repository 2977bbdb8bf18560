import { useState } from 'react'

import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { useLazy } from '@/ui/useLazy'

import type { Playing } from './OtherSounds'

const loadSounds = () => import('./OtherSounds').then(({ OtherSounds }) => OtherSounds)

/** What the project lets its designers hear of each other, read once it is asked for. */
export function OtherSoundsCard({ projectId, player }: { projectId: string; player: Playing }) {
  const [isOpen, setIsOpen] = useState(false)
  const OtherSounds = useLazy(loadSounds, isOpen, () => setIsOpen(false))
  return (
    <Card aria-labelledby="other-sounds">
      <CardHead
        id="other-sounds"
        title="Sounds by other designers"
        end={
          <Button variant="quiet" aria-expanded={isOpen} onClick={() => setIsOpen(!isOpen)}>
            {isOpen ? 'Hide' : 'Show'}
          </Button>
        }
      />
      {isOpen && OtherSounds && <OtherSounds projectId={projectId} player={player} />}
    </Card>
  )
}
