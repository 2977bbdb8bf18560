import { useQuery } from '@tanstack/react-query'

import { showToast } from '@/app/toast'
import { Button } from '@/ui/Button'
import { Card, CardHead } from '@/ui/Card'
import { day, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { sentence } from '@/ui/sentence'

import { type Contract, type MasterRetention, masterRetentionQuery, useKeepMasters } from './api'
import classes from './Contracts.module.css'

/** The retention of the masters delivered under a signed contract; a producer can keep them longer. */
export function MastersCard({ contract }: { contract: Contract }) {
  const { data: retention, error } = useQuery(masterRetentionQuery(contract.id))
  const keep = useKeepMasters(contract.id)
  if (error) return <Refusal error={error} />
  if (!retention || (retention.masters === 0 && retention.deleted_at === null)) return null
  const isKeptLonger = retention.kept_by !== null
  const isMine = contract.my_party === 'studio' && retention.masters > 0
  return (
    <Card aria-labelledby="masters">
      <CardHead id="masters" title="Masters" />
      <div className={classes.form}>
        <p>{keptUntil(retention)}</p>
        {retention.ends_on !== null &&
          retention.obstacles.map((obstacle) => (
            <p key={obstacle} className="small mid">
              {sentence(`not deleted while ${obstacle}`)}
            </p>
          ))}
        {isMine && (isKeptLonger || retention.ends_on !== null) && (
          <div className={classes.buttons}>
            <Button
              onClick={() =>
                keep.mutate(!isKeptLonger, {
                  onSuccess: () =>
                    showToast(
                      isKeptLonger ? 'Masters are deleted after the contract’s years.' : 'Masters are kept longer.',
                    ),
                })
              }
              aria-busy={keep.isPending}
            >
              {isKeptLonger ? 'Stop keeping longer' : 'Keep longer'}
            </Button>
          </div>
        )}
        <Refusal error={keep.error} />
      </div>
    </Card>
  )
}

function keptUntil({ masters, years, ends_on, announced_at, kept_by, deleted_at }: MasterRetention): string {
  if (masters === 0 && deleted_at !== null)
    return `Deleted on ${day(deleted_at)}, after the contract’s years. Game files stay.`
  const count = `${plural(masters, 'master')} of this designer in the project`
  if (kept_by !== null) return `${count}, kept longer by ${kept_by}.`
  if (ends_on === null || years === null) return `${count}, kept without an end: a contract names no years.`
  const because = `${plural(years, 'year')} after the last delivery`
  return announced_at === null
    ? `${count}, kept until ${day(ends_on)}, ${because}. Both parties are told 30 days before.`
    : `${count}, to be deleted on ${day(ends_on)}, ${because}. Download what you need before; game files stay.`
}
