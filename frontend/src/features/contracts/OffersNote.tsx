import { useQuery } from '@tanstack/react-query'
import { Link } from '@tanstack/react-router'

import { ButtonLink } from '@/ui/Button'
import { plural } from '@/ui/format'

import { changeOrdersQuery, type Contract } from './api'
import classes from './Contracts.module.css'

/** That something changed since both signed, for the two parties, and where a change order can say it. */
export function OffersNote({ contract, to }: { contract: Contract; to: string }) {
  const { data: all } = useQuery({ ...changeOrdersQuery(contract.id), enabled: contract.may.amend })
  if (!contract.may.amend || !all || all.offers.length === 0) return null
  return (
    <div className={`m-0 p-3-4 ${classes.asked} ${classes.redlines}`}>
      <p>{`${plural(all.offers.length, 'thing')} changed since you signed. A change order can say so.`}</p>
      <ButtonLink component={Link} to={to}>
        What changed
      </ButtonLink>
    </div>
  )
}
