import { useQuery } from '@tanstack/react-query'

import { ledgerQuery } from '@/money/api'
import { Card, CardHead } from '@/ui/Card'

import { LedgerTable } from './LedgerTable'

/** Every line that was ever written. */
export function LedgerCard({ contractId, title }: { contractId: string; title: string }) {
  const { data } = useQuery(ledgerQuery(contractId))
  if (!data) return null
  return (
    <Card aria-label={`Ledger, ${title}`}>
      <CardHead
        id={`ledger-${contractId}`}
        title="Ledger"
        count={data.lines.length}
        end="entries are added, never changed"
      />
      {data.lines.length === 0 ? (
        <p className="mid p-3-inset">
          Nothing is due yet. The ledger starts with the deposit or the first accepted cue.
        </p>
      ) : (
        <LedgerTable lines={data.lines} currency={data.currency} name={`Lines of the ledger, ${title}`} />
      )}
    </Card>
  )
}
