import { useMakeCalendar } from '@/money/api'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { Refusal } from '@/ui/Refusal'

/** What is due in this project, in one's own calendar. */
export function CalendarCard({ projectId }: { projectId: string }) {
  const make = useMakeCalendar(projectId)
  return (
    <Card aria-labelledby="calendar">
      <CardHead id="calendar" title="Calendar" end="what is due, as iCal" />
      <div className="stack p-3-inset">
        {make.data ? (
          <p className="mono wrap-anywhere" role="status">
            {make.data.url}
          </p>
        ) : (
          <p className="mid">
            A private iCal address for your calendar app: days of cues, and of milestones, invoices and contracts that
            you may see. Anyone who has it can read them. Creating a new link disables the old one.
          </p>
        )}
        <Refusal inset error={make.error} />
        {!make.data && (
          <div>
            <Button onClick={() => make.mutate()} disabled={make.isPending}>
              Create calendar link
            </Button>
          </div>
        )}
      </div>
    </Card>
  )
}
