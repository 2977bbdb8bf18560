import { TextInput } from '@mantine/core'
import { useDebouncedValue } from '@mantine/hooks'
import { useInfiniteQuery } from '@tanstack/react-query'
import { useEffect, useEffectEvent, useRef, useState } from 'react'

import { useHotkeys } from '@/app/keys'
import { Button } from '@/ui/Button'
import { EmptyState } from '@/ui/EmptyState'
import { FilterChip } from '@/ui/FilterChip'
import { Refusal } from '@/ui/Refusal'
import { LINE_STATES, LineState, percentOf, type VoiceLine } from '@/voice-lines'

import { linesQuery, type Script } from './api'
import { LineDialog } from './LineDialog'
import type { LinesSearch } from './search'
import classes from './VoiceLines.module.css'

interface LinesViewProps {
  projectId: string
  script: Script
  search: LinesSearch
  onChange: (next: Partial<LinesSearch>) => void
}

const TYPING_MS = 250

/** The script in one language, by scene. */
export function LinesView({ projectId, script, search, onChange }: LinesViewProps) {
  const language = search.language ?? script.original_language
  const query = useInfiniteQuery(linesQuery(projectId, { ...search, language }))
  const [openedId, setOpened] = useState<string | null>(null)
  const [typed, setTyped] = useState(search.search ?? '')
  const [settled] = useDebouncedValue(typed, TYPING_MS)
  const field = useRef<HTMLInputElement>(null)
  const apply = useEffectEvent((words: string) => {
    if (words !== (search.search ?? '')) onChange({ search: words || undefined })
  })
  useEffect(() => apply(settled), [settled])
  useHotkeys([
    { keys: 'j', label: 'Next line', group: 'Voice lines', run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous line', group: 'Voice lines', run: () => step(-1), repeats: true },
    { keys: '/', label: 'Search lines', group: 'Voice lines', run: () => field.current?.focus() },
  ])
  const lines = query.data?.pages.flatMap((page) => page.lines) ?? []
  const counts = query.data?.pages[0]?.counts ?? []
  const all = counts.reduce((sum, count) => sum + count.lines, 0)
  return (
    <>
      <div className={classes.tools}>
        <FilterChip count={all} pressed={search.state === undefined} onPress={() => onChange({ state: undefined })}>
          All
        </FilterChip>
        {counts.map(({ state, lines: count }) => (
          <FilterChip
            key={state}
            kind={LINE_STATES[state].kind}
            count={count}
            pressed={search.state === state}
            onPress={() => onChange({ state: search.state === state ? undefined : state })}
          >
            {LINE_STATES[state].word}
          </FilterChip>
        ))}
        <TextInput
          ref={field}
          className={classes.search}
          type="search"
          aria-label="Search lines"
          placeholder="Search lines"
          value={typed}
          onChange={(event) => setTyped(event.currentTarget.value)}
        />
      </div>
      <Refusal error={query.error} />
      {query.isSuccess && lines.length === 0 && (
        <EmptyState head="No matching lines">Choose another state or character, or clear the search.</EmptyState>
      )}
      {scenesOf(lines).map(({ scene, first, lines: own }) => (
        <section key={first} aria-label={scene || 'Without a scene'} className={`grid gap-2 ${classes.scene}`}>
          <h2>{scene || 'Without a scene'}</h2>
          <ul>
            {own.map((line) => (
              <li key={line.id} className={`hover ${classes.line}`}>
                <span className="strong">{line.character.name}</span>
                <span className={classes.words}>
                  <button
                    type="button"
                    data-line
                    className={`min-h-24px pointer p-0 border-0 bg-none pre-line ${classes.open}`}
                    onClick={() => setOpened(line.id)}
                  >
                    <span lang={language}>{line.text ?? <span className="dim">Not translated yet</span>}</span>
                  </button>
                  {language !== script.original_language && line.original_text !== null && (
                    <span className="small dim" lang={script.original_language}>
                      {line.original_text}
                    </span>
                  )}
                  {line.direction && <span className="small mid">({line.direction})</span>}
                </span>
                <span className={`small dim mono wrap-anywhere ${classes.path}`}>
                  {line.path}
                  {line.files.length > 1 && ` (${line.files.length} files)`}
                </span>
                <span className={classes.stands}>
                  <LineState state={line.state} />
                  {line.length_is_off && line.length_percent !== null && (
                    <span className="small tone-warn toned">Length {percentOf(line.length_percent)}</span>
                  )}
                </span>
              </li>
            ))}
          </ul>
        </section>
      ))}
      {query.hasNextPage && (
        <Button aria-busy={query.isFetchingNextPage} onClick={() => void query.fetchNextPage()}>
          Show more
        </Button>
      )}
      <LineDialog
        projectId={projectId}
        line={lines.find(({ id }) => id === openedId) ?? null}
        mayChange={script.may_change}
        onClose={() => setOpened(null)}
      />
    </>
  )
}

interface SceneLines {
  scene: string
  /** The id of its first line, since a scene can come back. */
  first: string
  lines: VoiceLine[]
}

/** Lines that follow each other in one scene, together. */
function scenesOf(lines: readonly VoiceLine[]): SceneLines[] {
  const scenes: SceneLines[] = []
  for (const line of lines) {
    const last = scenes.at(-1)
    if (last?.scene === line.scene) last.lines.push(line)
    else scenes.push({ scene: line.scene, first: line.id, lines: [line] })
  }
  return scenes
}

/** Move the focus from line to line. */
function step(by: 1 | -1): void {
  const lines = [...document.querySelectorAll<HTMLElement>('[data-line]')]
  const at = lines.findIndex((line) => line === document.activeElement)
  lines[at < 0 ? (by > 0 ? 0 : lines.length - 1) : at + by]?.focus()
}
