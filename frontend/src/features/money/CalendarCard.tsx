import { ApiProblem } from '@/api'
import { useMakeCalendar } from '@/money/api'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ProblemNote } from '@/ui/ProblemNote'

import classes from './Page.module.css'

/** The dates of the contracts in one's own calendar. */
export function CalendarCard({ projectId }: { projectId: string }) {
  const make = useMakeCalendar(projectId)
  return (
    <Card aria-labelledby="calendar">
      <CardHead id="calendar" title="Calendar" end="milestones as iCal" />
      <div className={classes.pad}>
        {make.data ? (
          <p className={`mono ${classes.address}`}>{make.data.url}</p>
        ) : (
          <p className="mid">
            A secret address for your calendar; whoever has it reads the dates. A new one takes the place of the last.
          </p>
        )}
        {make.error instanceof ApiProblem && <ProblemNote detail={make.error.detail} fix={make.error.fix} />}
        {!make.data && (
          <Button variant="quiet" onClick={() => make.mutate()}>
            Make an address
          </Button>
        )}
      </div>
    </Card>
  )
}
