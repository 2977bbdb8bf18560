import { ApiProblem } from '@/api'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { ConfirmInline } from '@/ui/ConfirmInline'
import { CopyButton } from '@/ui/CopyButton'
import { PageHead } from '@/ui/PageHead'
import { Refusal } from '@/ui/Refusal'
import { SaveStatus } from '@/ui/SaveStatus'
import { SecretOnce } from '@/ui/SecretOnce'
import { ShowMore } from '@/ui/ShowMore'
import { Skeleton } from '@/ui/Skeleton'
import { Table } from '@/ui/Table'

const nothing = () => undefined
const REFUSED = new ApiProblem(422, {
  code: 'rate-refused',
  detail: 'a master must be 44.1 kHz or more',
  fix: 'export it at 48 kHz',
})
const LINES = [
  { part: 'Alpha', minor: 1800 },
  { part: 'Beta', minor: 4320 },
]

/** Everything that waits, fails or asks, once. */
export function Waiting() {
  return (
    <Card aria-labelledby="waiting" style={{ marginTop: 'var(--sl-4)' }}>
      <CardHead id="waiting" title="Waiting and failing" note="shown after 300 ms, never before" />
      <div className="stack inset">
        <PageHead title="Delivery 12" actions={<Button variant="primary">Send</Button>}>
          A page’s head, with its acts.
        </PageHead>
        <div className="row wrap">
          <Button variant="primary">Send to the designer</Button>
          <Button variant="primary" aria-busy>
            Send to the designer
          </Button>
          <Button icon="upload" aria-busy>
            Read a file
          </Button>
          <Button variant="quiet" aria-busy>
            Cancel
          </Button>
        </div>
        <Skeleton rows={3} />
        <div className="row wrap">
          <SaveStatus state="saving" />
          <SaveStatus state="saved" at="21:04" />
          <SaveStatus state="failed" onRetry={nothing} />
        </div>
        <Refusal error={REFUSED} action={<Button>Use 48 kHz</Button>} />
        <Table
          label="Parts of the price"
          rows={LINES}
          keyOf={({ part }) => part}
          columns={[
            { head: 'Part', rowHead: true, cell: ({ part }) => part },
            { head: 'EUR', numeric: true, cell: ({ minor }) => (minor / 100).toFixed(2) },
          ]}
        />
        <ShowMore list={{ hasNextPage: true, isFetchingNextPage: false, fetchNextPage: nothing }}>
          Earlier parts
        </ShowMore>
        <CopyButton text="https://example.com/listen/1" what="Link">
          Copy link
        </CopyButton>
        <SecretOnce secret="sl_live_8Kq2f0Zt" what="Token" name="CI" onDone={nothing}>
          Keep it where the build reads its secrets.
        </SecretOnce>
        <ConfirmInline
          action="Terminate contract"
          keep="Keep contract"
          consequence="It ends on 14 December. The designer is told at once."
          onConfirm={nothing}
        >
          Terminate…
        </ConfirmInline>
      </div>
    </Card>
  )
}
