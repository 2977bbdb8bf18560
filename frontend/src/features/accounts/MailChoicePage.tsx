import { useQuery } from '@tanstack/react-query'
import { Link, useParams } from '@tanstack/react-router'

import { ApiProblem } from '@/api'
import { Sheet } from '@/ui/Sheet'
import { useTitle } from '@/app/title'
import { Button } from '@/ui/Button'

import classes from './Account.module.css'
import { mailChoiceQuery, useChooseMail } from './api'
import { CADENCE_WORDS, cadencesOf, NEWS_WORDS } from './mailWords'
import { CardProblem } from './CardProblem'

const STANDS = { at_once: 'at once', hourly: 'once an hour', daily: 'once a day', never: 'no more' } as const

/** The page of the link at the end of a mail: fewer of them, without signing in. */
export function MailChoicePage() {
  useTitle('Emails')
  const { secret } = useParams({ from: '/guest/mails/$secret' })
  const { data: choice, error } = useQuery(mailChoiceQuery(secret))
  const choose = useChooseMail(secret)
  if (error instanceof ApiProblem && error.status === 404) {
    return (
      <Sheet>
        <h1>This link is incomplete</h1>
        <p className="mid">Open it from the email again. Or sign in, and choose your emails on your account’s page.</p>
        <p className="mt-4">
          <Link className="link" to="/account">
            Go to your account
          </Link>
        </p>
      </Sheet>
    )
  }
  if (choice === undefined) return <Sheet>{error && <CardProblem error={error} />}</Sheet>
  return (
    <Sheet>
      <h1>Emails to {choice.email}</h1>
      <p className="mid">
        {choice.news.map((news) => NEWS_WORDS[news].label).join(', ')}
        {choice.cadence ? (choice.cadence === 'never' ? ': not sent.' : `: sent ${STANDS[choice.cadence]}.`) : '.'}
      </p>
      <CardProblem error={choose.error} />
      <div className={`flex wrap gap-2 ${classes.choices}`} role="group" aria-label="How often they are sent">
        {cadencesOf(choice.can_stop).map((cadence) => (
          <Button
            key={cadence}
            aria-pressed={cadence === choice.cadence}
            variant={cadence === choice.cadence ? 'primary' : undefined}
            aria-busy={choose.isPending && choose.variables === cadence}
            onClick={() => choose.mutate(cadence)}
          >
            {CADENCE_WORDS[cadence]}
          </Button>
        ))}
      </div>
      {choose.isSuccess && (
        <p role="status">
          {choose.data.cadence === 'never'
            ? 'Saved. You get no more of these emails.'
            : `Saved. These emails are sent ${STANDS[choose.data.cadence ?? 'at_once']}.`}
        </p>
      )}
      {!choice.can_stop && (
        <p className="small mid">Emails about contracts and payments can’t be turned off: they name days to keep.</p>
      )}
      <p className="small mt-4">
        <Link className="link" to="/account">
          All your emails, and quiet hours
        </Link>
      </p>
    </Sheet>
  )
}
