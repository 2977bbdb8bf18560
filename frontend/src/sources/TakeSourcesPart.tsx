import { useQuery } from '@tanstack/react-query'
import { useState } from 'react'

import { Button } from '@/ui/Button'
import { useLazy } from '@/ui/useLazy'

import { takeSourcesQuery, useStateTakeSources } from './api'
import { SameSounds } from './SameSounds'
import { SourcesText } from './SourcesText'

const loadForm = () => import('./SourcesForm').then(({ SourcesForm }) => SourcesForm)

/** The sources of one version; its designer can change them until they are on record. */
export function TakeSourcesPart({ takeId, mayState }: { takeId: string; mayState: boolean }) {
  const { data: read } = useQuery(takeSourcesQuery(takeId))
  const save = useStateTakeSources(takeId)
  const [changing, setChanging] = useState(false)
  const SourcesForm = useLazy(loadForm, changing, () => setChanging(false))
  if (!read) return null
  if (changing && SourcesForm) {
    return (
      <SourcesForm
        initial={read.stated?.sources ?? null}
        error={save.error}
        isPending={save.isPending}
        onSave={(sources) => save.mutate(sources, { onSuccess: () => setChanging(false) })}
        onCancel={() => setChanging(false)}
      />
    )
  }
  return (
    <div className="grid gap-2">
      <SourcesText words={read.stated?.words ?? null} openPoints={read.open_points} />
      <p className="small dim">
        {read.is_fixed
          ? 'On record since the approval.'
          : read.stated && (read.is_own ? 'Stated for this version.' : 'Stated for its delivery.')}
      </p>
      <SameSounds takeId={takeId} />
      {mayState && !read.is_fixed && (
        <span>
          <Button icon="pencil" onClick={() => setChanging(true)}>
            {read.stated ? 'Change sources' : 'State sources'}
          </Button>
        </span>
      )}
    </div>
  )
}
