import type { Cadence, News } from './api'

/** What mails are about, as the person reads it. */
export const NEWS_WORDS: Record<News, { label: string; hint: string }> = {
  sounds: { label: 'Sounds', hint: 'to review, returned, approved, changes requested' },
  talk: { label: 'Questions and replies', hint: 'on cues and versions' },
  mentions: { label: 'Mentions', hint: 'comments and change requests that name you' },
  list: { label: 'Sound list and builds', hint: 'cues added, changed or cut, refused builds, people who joined' },
  contracts: { label: 'Contracts and payments', hint: 'to sign, changed, invoiced' },
  hiring: { label: 'Postings and bids', hint: 'bids, questions, the choice' },
}

export const CADENCE_WORDS: Record<Cadence, string> = {
  at_once: 'At once',
  hourly: 'Once an hour',
  daily: 'Once a day',
  never: 'Never',
}

/** Contracts and payments have days to keep: their mails are never turned off. */
export const cadencesOf = (canStop: boolean): Cadence[] =>
  canStop ? ['at_once', 'hourly', 'daily', 'never'] : ['at_once', 'hourly', 'daily']
