import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { Card, CardHead } from '@/ui/Card'

import { fitQuery, type Take } from './api'
import { FitPicture } from './FitPicture'

/** How a version lies among the approved sounds of its category, or of the palette; for the team. */
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
