import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { deliverySourcesQuery, useStateDeliverySources } from '@/sources/api'
import { SourcesText } from '@/sources/SourcesText'
import { Button } from '@/ui/Button'
import { plural } from '@/ui/format'
import { useLazy } from '@/ui/useLazy'

const loadForm = () => import('@/sources/SourcesForm').then(({ SourcesForm }) => SourcesForm)

/** What the files of a delivery were made from, asked once for all of them. */
export function DeliverySources({ deliveryId, number }: { deliveryId: string; number: number }) {
  const { data: read } = useQuery(deliverySourcesQuery(deliveryId))
  const save = useStateDeliverySources(deliveryId)
  const [changing, setChanging] = useState(false)
  const SourcesForm = useLazy(loadForm, changing, () => setChanging(false))
  if (!read) return null
  const { stated, remembered } = read
  const own = read.takes.filter(({ is_own: isOwn }) => isOwn).length
  return (
    <section className="grid gap-2 border-t p-10px-inset" aria-label={`Sources of delivery ${number}`}>
      <p className="strong">Sources</p>
      {changing && SourcesForm ? (
        <SourcesForm
          initial={stated?.sources ?? remembered}
          error={save.error}
          isPending={save.isPending}
          onSave={(sources) => save.mutate(sources, { onSuccess: () => setChanging(false) })}
          onCancel={() => setChanging(false)}
        />
      ) : (
        <>
          {stated ? (
            <SourcesText words={stated.words} openPoints={[]} />
          ) : (
            <p className="mid">
              What are the files of this delivery made from? Asked once for all of them; a version can differ on its own
              page.
            </p>
          )}
          {own > 0 && <p className="small dim">{plural(own, 'version')} with a statement of its own.</p>}
          <span className="row">
            {!stated && remembered && (
              <Button onClick={() => save.mutate(remembered)} disabled={save.isPending}>
                Same as last time
              </Button>
            )}
            <Button icon="pencil" variant={stated ? 'quiet' : undefined} onClick={() => setChanging(true)}>
              {stated ? 'Change sources' : 'State sources'}
            </Button>
          </span>
        </>
      )}
    </section>
  )
}
