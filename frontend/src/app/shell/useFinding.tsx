import { type Found, useSearchProvider } from '../palette'
import type { Hit, Search } from './found'

/** Loaded at the first search, so that no page waits for it. */
const loadFound = () => import('./found')

/** Let the palette find cues, files, people, contracts and what was said in a project, and some of it in all others. */
export function useFinding(projectId: string | undefined, designs: boolean, go: (path: string) => void): void {
  const search: Search = { projectId, designs, go }
  const here =
    (...kinds: Hit['kind'][]) =>
    async (typed: string, signal: AbortSignal): Promise<Found[]> =>
      (await loadFound()).findHere(kinds, search, typed, signal)
  useSearchProvider({ id: 'sounds', title: 'Sounds', search: here('cue') })
  useSearchProvider({ id: 'files', title: 'Files', search: here('file') })
  useSearchProvider({ id: 'people', title: 'People and contracts', search: here('person', 'contract') })
  useSearchProvider({
    id: 'elsewhere',
    title: projectId === undefined ? 'In your projects' : 'In other projects',
    search: async (typed, signal) => (await loadFound()).findElsewhere(search, typed, signal),
    last: true,
  })
  useSearchProvider({
    id: 'reasons',
    title: 'Reasons and labels',
    search: async (typed, signal) => (await loadFound()).findSaid(search, typed, signal),
    last: true,
  })
  useSearchProvider({ id: 'said', title: 'Comments and questions', search: here('comment', 'question'), last: true })
}
