import type { HeldFile, PrecheckState } from './held'

const MOST_CHARS = 255

/** wrong: it would come back; fixable: so it would, with a fix for all of it; unnamed: its name says no cue; ready: it was renamed, and nothing else holds it. */
export type HeldState = 'wrong' | 'fixable' | 'unnamed' | 'ready'

export const baseName = (path: string): string => path.slice(path.lastIndexOf('/') + 1)

export function heldStateOf({ findings, cue, listName }: HeldFile): HeldState {
  const errors = findings.filter(({ severity }) => severity === 'error')
  if (errors.length > 0) return errors.every(({ auto_fix }) => auto_fix != null) ? 'fixable' : 'wrong'
  return cue === '' && listName !== null ? 'unnamed' : 'ready'
}

/** Whether another name may help: a file with its cue and no finding in its name keeps the one that it has. */
export const isRenamable = ({ findings, cue, listName, firstName }: HeldFile): boolean =>
  firstName !== null ||
  listName !== null ||
  cue === '' ||
  findings.some(({ code }) => code.startsWith('naming:') && code !== 'naming:listed')

export const wantedName = ({ wanted }: HeldFile): string => wanted.trim()

export const isPossibleName = (name: string): boolean => name !== '' && name.length <= MOST_CHARS

export const isChanged = (file: HeldFile): boolean => wantedName(file) !== baseName(file.picked.path)

const endingOf = (name: string): string => /.(\.[^.]*)$/.exec(name)?.[1] ?? ''

/** What is wrong with the wanted names, by the file's id; two files may not have one name on any system. */
export function nameProblems(held: readonly HeldFile[]): ReadonlyMap<number, string> {
  const keyOf = (file: HeldFile) => (isChanged(file) ? wantedName(file) : file.picked.path).toLowerCase()
  const counts = new Map<string, number>()
  for (const file of held) counts.set(keyOf(file), (counts.get(keyOf(file)) ?? 0) + 1)
  const problems = new Map<number, string>()
  for (const file of held) {
    const problem = isChanged(file) ? ownProblem(file) : null
    if (problem !== null) problems.set(file.id, problem)
    else if ((counts.get(keyOf(file)) ?? 0) > 1)
      problems.set(file.id, `Another file here has the name ${wantedName(file)} too. Change one of the two.`)
  }
  return problems
}

function ownProblem(file: HeldFile): string | null {
  const wanted = wantedName(file)
  const ending = endingOf(file.picked.path)
  if (wanted === '') return 'The name is empty. Type a name.'
  if (/[/\\]/.test(wanted)) return 'The name has a slash. Type a name without one.'
  if (wanted.length > MOST_CHARS) return `The name has ${wanted.length} characters. At most ${MOST_CHARS} are kept.`
  if (endingOf(wanted).toLowerCase() === ending.toLowerCase()) return null
  return ending === '' ? 'The file has no ending. Type a name without one.' : `The name must end in ${ending}.`
}

/** The renamings that can be undone: those of files that still wait. */
export function renamesHere({ held, renames }: Pick<PrecheckState, 'held' | 'renames'>): PrecheckState['renames'] {
  const here = new Set(held.map(({ id }) => id))
  return renames.filter((files) => files.some(({ id }) => here.has(id)))
}
