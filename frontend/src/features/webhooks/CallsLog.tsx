import { useInfiniteQuery } from '@tanstack/react-query'

import { Button } from '@/ui/Button'
import { ago, clock, day, plural } from '@/ui/format'
import { Refusal } from '@/ui/Refusal'
import { ShowMore } from '@/ui/ShowMore'

import { type Call, callsQuery, useReplay, type Webhook } from './api'
import classes from './Webhooks.module.css'
import { eventWords, STATE_WORDS } from './words'

/** What was sent to an address, and what was answered. */
export function CallsLog({ webhook }: { webhook: Webhook }) {
  const list = useInfiniteQuery(callsQuery(webhook.id))
  const { data, error } = list
  const replay = useReplay()
  return (
    <section aria-label={`Log of ${new URL(webhook.url).host}`}>
      {[error, replay.error].map((error, at) => (
        <Refusal key={at} error={error} />
      ))}
      {data?.length === 0 && <p className="small mid">Nothing was sent yet.</p>}
      <ul className="grid gap-1">
        {data?.map((call) => (
          <li key={call.id}>
            <OneCall call={call} mayReplay={webhook.disabled_at === null} onReplay={() => replay.mutate(call)} />
          </li>
        ))}
      </ul>
      <ShowMore list={list}>Show earlier messages</ShowMore>
    </section>
  )
}

function OneCall({ call, mayReplay, onReplay }: { call: Call; mayReplay: boolean; onReplay: () => void }) {
  const { event, state, created_at: at, tries, status, problem, took_ms: tookMs, next_at: nextAt } = call
  const isTried = tries > 0
  return (
    <details>
      <summary className="small">
        <span className={state === 'failed' ? 'strong' : ''}>{STATE_WORDS[state]}</span>{' '}
        <span>{eventWords(event)}</span>{' '}
        <time className="dim" dateTime={at} title={`${day(at)}, ${clock(at)}`}>
          {ago(at)}
        </time>{' '}
        {problem && <span className="mid">{problem}</span>}
      </summary>
      <div className={`grid gap-2 ${classes.call}`}>
        <p className="small mid">
          {isTried ? `${plural(tries, 'attempt')}, the last took ${tookMs ?? 0} ms` : 'Not sent yet'}
          {status !== null && `, answered ${status}`}
          {isTried && nextAt && `. Next attempt ${day(nextAt)}, ${clock(nextAt)}`}.
        </p>
        {call.attempts.length > 1 && (
          <>
            <p className="small strong">Attempts</p>
            <ol aria-label="Attempts" className="small">
              {call.attempts.map((attempt) => (
                <li key={attempt.tried_at}>
                  <time dateTime={attempt.tried_at}>{`${day(attempt.tried_at)}, ${clock(attempt.tried_at)}`}</time>
                  {`: ${attempt.problem || `answered ${attempt.status}`}, in ${attempt.took_ms} ms`}
                  {attempt.answer && <pre className="mono">{attempt.answer}</pre>}
                </li>
              ))}
            </ol>
          </>
        )}
        {call.attempts.length <= 1 && call.answer && (
          <>
            <p className="small strong">Answer</p>
            <pre className="mono small">{call.answer}</pre>
          </>
        )}
        <p className="small strong">Message</p>
        <pre className="mono small">{call.body}</pre>
        {mayReplay && (
          <Button icon="turn" onClick={onReplay}>
            Send again<span className="visually-hidden">: {eventWords(event)}</span>
          </Button>
        )}
      </div>
    </details>
  )
}
