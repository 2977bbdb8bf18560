import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { fixesQuery, useUseFixes } from '@/fixing'
import { Button } from '@/ui/Button'
import { Refusal } from '@/ui/Refusal'
import { plural } from '@/ui/format'

/** One press for every returned version of which a fixed copy is made: "Fix 21". */
export function FixAll({ projectId }: { projectId: string }) {
  const { data: offers } = useQuery(fixesQuery(projectId))
  const ready = offers?.filter(({ take_state: state, state: fix }) => state === 'returned' && fix === 'made') ?? []
  const fixing = useUseFixes()
  if (ready.length < 2 && !fixing.isPending && !fixing.error) return null
  return (
    <>
      <Button
        icon="spanner"
        aria-busy={fixing.isPending}
        disabled={fixing.isPending}
        onClick={() =>
          fixing.mutate(
            ready.map(({ take_id }) => take_id),
            {
              onSuccess: (count) =>
                showToast(`${plural(count, 'sound')} fixed. The copies are being checked; your originals are kept.`),
            },
          )
        }
      >
        {fixing.isPending ? `Fixing ${ready.length}` : `Fix ${ready.length}`}
      </Button>
      <Refusal error={fixing.error} />
    </>
  )
}
