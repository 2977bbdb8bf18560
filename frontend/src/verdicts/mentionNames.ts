import { type QueryClient } from '@tanstack/react-query'
import { queryById } from '@/api'
import type { RefObject } from 'react'

import { queryKeys } from '@/api/queryKeys'
import type { components } from '@/api/schema.gen'

export type Mentionable = components['schemas']['PersonBrief']
export type Mention = components['schemas']['MentionRead']

/** A field in which people are mentioned in words on a version. */
export interface MentionsProps {
  takeId: string
  field: RefObject<HTMLInputElement | HTMLTextAreaElement | null>
  text: string
  onText: (text: string) => void
}

/** The people who may see a version: those who can be mentioned there. */
export const mentionableQuery = queryById('/v1/takes/{take_id}/people', queryKeys.peopleToMention, {
  staleTime: 60_000,
})

/** The people whose names stand in a text after an @; of names that begin alike the longer one is meant. */
export function mentionedIn(text: string, people: readonly Mentionable[]): string[] {
  const ids: string[] = []
  let left = text
  for (const { id, name } of people.toSorted((a, b) => b.name.length - a.name.length)) {
    if (!left.includes(`@${name}`)) continue
    ids.push(id)
    left = left.replaceAll(`@${name}`, ' ')
  }
  return ids
}

/** Whom a text mentions, before it is sent. */
export const mentionsOf = async (client: QueryClient, takeId: string, text: string): Promise<string[]> =>
  text.includes('@') ? mentionedIn(text, await client.ensureQueryData(mentionableQuery(takeId))) : []

/** What is typed after the @ before the caret; null where no name is being typed. */
export function typedName(text: string, caret: number): { from: number; query: string } | null {
  const match = /(?:^|[\s(])@([^@\n]{0,40})$/u.exec(text.slice(0, caret))
  return match ? { from: caret - (match[1] ?? '').length - 1, query: match[1] ?? '' } : null
}

/** The people whose name, or a word of it, begins with what is typed. */
export function offered(people: readonly Mentionable[], query: string): Mentionable[] {
  const prefix = query.toLocaleLowerCase()
  const begins = (name: string) => name.toLocaleLowerCase().startsWith(prefix)
  return people.filter(({ name }) => [name, ...name.split(' ')].some(begins)).slice(0, 6)
}
