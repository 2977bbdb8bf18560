import { plural } from '@/ui/format'

import type { Guess, Take, TrayAction } from './api'

/** Files of one folder, under its path; files without a folder come first, under an empty one. */
export interface FolderGroup {
  folder: string
  takes: Take[]
}

/** The cue that all files of a folder may be for, with the variation that each name says. */
export interface FolderMatch {
  cue: { id: string; name: string }
  moves: { take_id: string; cue_id: string; variation: number | null }[]
}

const FOLDER = /^(.*)[/\\][^/\\]*$/

const folderOf = ({ file_name }: Take): string => FOLDER.exec(file_name)?.[1] ?? ''
export const baseOf = ({ file_name }: Take): string => file_name.split(/[/\\]/).at(-1) ?? file_name

export function groupsOf(takes: readonly Take[]): FolderGroup[] {
  const groups = new Map<string, Take[]>()
  for (const take of takes) {
    const folder = folderOf(take)
    groups.set(folder, [...(groups.get(folder) ?? []), take])
  }
  return [...groups]
    .map(([folder, of]) => ({ folder, takes: of }))
    .sort((one, other) => one.folder.localeCompare(other.folder))
}

const guessesOf = ({ sure, guesses }: Take): readonly Guess[] => (sure ? [sure] : guesses)

/** The likeliest cue for a whole folder; null where its files have none in common, or are more than the cue's set. */
export function folderMatch(takes: readonly Take[]): FolderMatch | null {
  const [first, ...others] = takes.map(guessesOf)
  if (!first || others.length === 0) return null
  const ranked = first.flatMap((guess, rank) => {
    const ranks = others.map((guesses) => guesses.findIndex(({ cue_id }) => cue_id === guess.cue_id))
    const holds = guess.variations >= takes.length && !ranks.includes(-1)
    return holds ? [{ guess, rank: ranks.reduce((sum, each) => sum + each, rank) }] : []
  })
  const [best] = ranked.sort((one, other) => one.rank - other.rank)
  if (!best) return null
  const { cue_id, name } = best.guess
  const variations = takes.map((take) => guessesOf(take).find((guess) => guess.cue_id === cue_id)?.variation ?? null)
  const distinct = new Set(variations.filter((variation) => variation !== null))
  const said = distinct.size === takes.length
  return {
    cue: { id: cue_id, name },
    moves: takes.map(({ id }, place) => ({
      take_id: id,
      cue_id,
      variation: said ? (variations[place] ?? null) : null,
    })),
  }
}

/** The files from one to another in the order shown, both included. */
export function between(takes: readonly Take[], from: string, to: string): string[] {
  const places = [takes.findIndex(({ id }) => id === from), takes.findIndex(({ id }) => id === to)]
  const [first = 0, last = 0] = places.sort((one, other) => one - other)
  return first < 0 ? [to] : takes.slice(first, last + 1).map(({ id }) => id)
}

export const slotName = ({ name, variation, variations }: Guess): string =>
  variations > 1 && variation !== null ? `${name} ${String(variation).padStart(2, '0')}` : name

export const files = (count: number): string => plural(count, 'file')

const DONE: Record<TrayAction['kind'], string> = {
  matched: 'matched',
  moved: 'moved',
  discarded: 'discarded; their masters are kept',
  restored: 'back in the tray',
  split: 'changed by the split',
}

export const actionLine = ({ kind, take_ids }: TrayAction): string => `${files(take_ids.length)} ${DONE[kind]}.`
