import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'
import { Fragment } from 'react'

import { Card, CardHead } from '@/ui/Card'
import { figure } from '@/ui/format'

import { fitQuery, type Take } from './api'
import { FitPicture } from './FitPicture'

/** How a version lies among the approved sounds of its category, or of the palette. */
export function FitCard({ take }: { take: Take }) {
  const { data: fit } = useQuery(fitQuery(take))
  if (!fit) return null
  const beside =
    fit.basis === 'category'
      ? `compared with the approved sounds in ${fit.category || 'no category'}`
      : 'compared with the palette'
  return (
    <Card aria-labelledby="fit">
      <CardHead id="fit" title="Match with the palette" end={fit.basis ? beside : undefined} />
      <div className="grid gap-3 p-3-inset-14px">
        <p>
          {fit.says}
          {fit.is_apart && ' That may be intended. Trust your ears.'}
        </p>
        {fit.basis !== null && <FitPicture fit={fit} />}
        {fit.sounds_like.length > 0 && (
          <p>
            Sounds like{' '}
            {fit.sounds_like.map(({ cue, take_id: takeId, distance_db: distanceDb }, at) => (
              <Fragment key={takeId}>
                {at > 0 && ', '}
                <Link className="link" to="/takes/$takeId" params={{ takeId }}>
                  {cue.name}
                </Link>{' '}
                ({figure(distanceDb, 1)} dB)
              </Fragment>
            ))}
            . The distance is between timbres, of approved sounds.
          </p>
        )}
        {fit.first_delivery_id !== null && (
          <p>
            This is the first delivery of {take.designer.name}, who follows other designers.{' '}
            <Link className="link" to="/deliveries/$deliveryId/fit" params={{ deliveryId: fit.first_delivery_id }}>
              Compare the whole delivery with earlier work
            </Link>
          </p>
        )}
      </div>
    </Card>
  )
}
