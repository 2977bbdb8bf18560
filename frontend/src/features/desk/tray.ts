import { plural } from '@/ui/format'

import type { Guess, Take, TrayAction } from './api'

/** Files of one folder, under its path; files without a folder come first, under an empty one. */
export interface FolderGroup {
  folder: string
  takes: Take[]
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
}

export const actionLine = ({ kind, take_ids }: TrayAction): string => `${files(take_ids.length)} ${DONE[kind]}.`
