import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { showToast } from '@/app/toast'
import { gateWords, PHASE_WORDS, phasesQuery, useApprovePalette } from '@/phases'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'

import classes from './Overview.module.css'

/** The phases of the production and the gates between them; nothing where no cue names a phase. */
export function PhasesCard({ projectId }: { projectId: string }) {
  const { data, error } = useQuery(phasesQuery(projectId))
  const approve = useApprovePalette(projectId)
  if (!data || data.phases.length === 0) return <Refusal inset error={error} />
  const at = data.phases.findLast(({ is_open: isOpen }) => isOpen)
  return (
    <Card className="mt-4" aria-labelledby="phases">
      <CardHead id="phases" title="Phases" note={at && (at.is_done ? 'all done' : `now ${PHASE_WORDS[at.phase]}`)} />
      <div className="grid gap-3 p-3-inset-4">
        <ul className={classes.rows} aria-label="Phases">
          {data.phases.map((phase) => (
            <li key={phase.phase}>
              <Link
                className="link strong"
                to="/projects/$projectId/sound-list"
                params={{ projectId }}
                search={{ phase: phase.phase }}
              >
                {PHASE_WORDS[phase.phase]}
              </Link>
              <span className="mid">{`${phase.accepted} of ${phase.cues}`}</span>
              <span className="small mid grow">
                {phase.is_done ? 'done' : phase.is_open ? gateWords(phase) : 'opens when the previous phase is done'}
              </span>
            </li>
          ))}
        </ul>
        <Refusal error={approve.error} />
        {data.may_approve_palette && (
          <div>
            <Button
              variant="primary"
              aria-busy={approve.isPending}
              onClick={() => approve.mutate(undefined, { onSuccess: () => showToast('The palette is approved.') })}
            >
              Approve palette
            </Button>
          </div>
        )}
        {data.palette_approval && (
          <p className="small mid">{`${data.palette_approval.approver.name} approved the palette as a set.`}</p>
        )}
      </div>
    </Card>
  )
}
