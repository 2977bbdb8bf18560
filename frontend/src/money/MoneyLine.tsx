import { Link, type LinkProps } from '@tanstack/react-router'

import { Card } from '@/ui/Card'

import type { Figures } from './api'
import classes from './Money.module.css'
import { amount, money } from './words'

interface MoneyLineProps {
  figures: Figures
  currency: string
  /** Who reads: the team pays, the designer is paid. */
  side: 'team' | 'designer'
  /** What the selected cue would make due. */
  wouldOweMinor?: number
  /** Where the lines behind the figures stand; left out on that page itself. */
  projectId?: string
}

/** What is paid, due, open and saved; together it is what was agreed. */
export function MoneyLine({ figures, currency, side, wouldOweMinor = 0, projectId }: MoneyLineProps) {
  const { agreed_minor, paid_minor, due_minor, open_minor, saved_minor } = figures
  const parts = [
    { name: 'Paid', minor: paid_minor, look: classes.paid },
    { name: 'Due', minor: due_minor, look: classes.due },
    { name: 'Remaining', minor: open_minor, look: classes.open },
    { name: 'Saved by cuts', minor: saved_minor, look: classes.saved },
  ]
  return (
    <Card className={`grid items-center ${classes.line}`} aria-label={`Money in ${currency}`}>
      <div>
        <p className="small mid">{side === 'team' ? 'Due to the designer now' : 'You are owed'}</p>
        <p className={classes.figure}>{money(due_minor, currency)}</p>
        {projectId !== undefined && (
          <Link className="link small" to={`/projects/${projectId}/money` as LinkProps['to']}>
            Invoices and ledger
          </Link>
        )}
      </div>
      <div>
        <div className={`flex gap-2px overflow-hidden ${classes.bar}`} aria-hidden="true">
          {parts.map(
            ({ name, minor, look }) => minor > 0 && <span key={name} className={look} style={{ flexGrow: minor }} />,
          )}
        </div>
        <ul className={`small flex wrap mt-2 ${classes.legend}`}>
          {parts.map(
            ({ name, minor, look }) =>
              (minor !== 0 || name !== 'Saved by cuts') && (
                <li key={name}>
                  <span className={`${classes.mark} ${look}`} aria-hidden="true" />
                  <span className="mid">{name}</span> {amount(minor, currency)}
                  {name === 'Due' && wouldOweMinor > 0 && (
                    <span className="mid">({amount(due_minor + wouldOweMinor, currency)} after the next approval)</span>
                  )}
                </li>
              ),
          )}
          <li className={`end ${classes.agreed}`}>
            <span className="mid">Agreed</span> {money(agreed_minor, currency)}
          </li>
        </ul>
      </div>
    </Card>
  )
}
