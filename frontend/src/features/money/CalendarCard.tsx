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
            A private iCal URL for your calendar app. Anyone with the link can see the dates. Creating a new link
            disables the old one.
          </p>
        )}
        {make.error instanceof ApiProblem && <ProblemNote detail={make.error.detail} fix={make.error.fix} />}
        {!make.data && (
          <Button variant="quiet" onClick={() => make.mutate()}>
            Create calendar link
          </Button>
        )}
      </div>
    </Card>
  )
}
