import { Modal } from '@mantine/core'
import { useEffect, useId, useMemo, useRef, useState } from 'react'

import { plural } from '@/ui/format'
import { Icon } from '@/ui/Icon'
import { Key } from '@/ui/Key'

import { KeyScope } from '../keys'
import { fitting } from './fuzzy'
import classes from './Palette.module.css'
import {
  type Command,
  type Found,
  type SearchProvider,
  useRegisteredCommands,
  useRegisteredProviders,
} from './registry'

const COMMANDS_SHOWN = 8
const ASK_AFTER_MS = 60

interface Section {
  title: string
  lines: Line[]
}

type Line = { id: string; act: () => void } & ({ command: Command } | { found: Found })

/** Ctrl/Cmd K: find a sound, do something, read what was said. Arrows and Enter only. */
export function CommandPalette({ opened, onClose }: { opened: boolean; onClose: () => void }) {
  return (
    <Modal.Root opened={opened} onClose={onClose} size={560} yOffset="12vh" transitionProps={{ duration: 0 }}>
      <Modal.Overlay backgroundOpacity={0.2} />
      <Modal.Content aria-label="Search or run a command" className={classes.content}>
        {opened && (
          <KeyScope>
            <PaletteBody onClose={onClose} />
          </KeyScope>
        )}
      </Modal.Content>
    </Modal.Root>
  )
}

function useFound(query: string, providers: SearchProvider[]): { asking: boolean; found: Map<string, Found[]> } {
  const [answered, setAnswered] = useState<{ query: string; found: Map<string, Found[]> }>({
    query: '',
    found: new Map(),
  })
  useEffect(() => {
    const term = query.trim()
    if (term === '') {
      setAnswered({ query: '', found: new Map() })
      return
    }
    const ending = new AbortController()
    const timer = setTimeout(() => {
      const results = new Map<string, Found[]>()
      void Promise.allSettled(
        providers.map(async (provider) => {
          results.set(provider.id, await provider.search(term, ending.signal))
          if (!ending.signal.aborted) setAnswered({ query: '', found: new Map(results) })
        }),
      ).then(() => {
        if (!ending.signal.aborted) setAnswered({ query: term, found: results })
      })
    }, ASK_AFTER_MS)
    return () => {
      clearTimeout(timer)
      ending.abort()
    }
  }, [query, providers])
  return { asking: answered.query !== query.trim() && providers.length > 0, found: answered.found }
}

function PaletteBody({ onClose }: { onClose: () => void }) {
  const [query, setQuery] = useState('')
  const [at, setAt] = useState(0)
  const listId = useId()
  const input = useRef<HTMLInputElement>(null)
  const commands = useRegisteredCommands()
  const providers = useRegisteredProviders()
  const { asking, found } = useFound(query, providers)

  const sections = useMemo<Section[]>(() => {
    const ofProviders = (last: boolean) =>
      providers
        .filter((provider) => Boolean(provider.last) === last)
        .map((provider) => ({
          title: provider.title,
          lines: (found.get(provider.id) ?? []).map((item) => ({
            id: `${provider.id}-${item.id}`,
            act: item.open,
            found: item,
          })),
        }))
    const fits = fitting(query, commands, (command) => [command.label, ...(command.also ?? [])])
    const doing = fits
      .slice(0, COMMANDS_SHOWN)
      .map((command) => ({ id: `do-${command.id}`, act: command.run, command }))
    return [...ofProviders(false), { title: 'Do', lines: doing }, ...ofProviders(true)].filter(
      (section) => section.lines.length > 0,
    )
  }, [commands, found, providers, query])

  const lines = sections.flatMap((section) => section.lines)
  const selected = lines[Math.min(at, lines.length - 1)]
  const optionId = (line: Line) => `${listId}-${line.id}`

  // Mantine's own focus trap looks for it before it is there where the palette is loaded as it opens.
  useEffect(() => input.current?.focus(), [])

  useEffect(() => {
    if (selected) document.getElementById(`${listId}-${selected.id}`)?.scrollIntoView({ block: 'nearest' })
  }, [selected, listId])

  const act = (line: Line | undefined) => {
    if (line === undefined) return
    onClose()
    line.act()
  }

  return (
    <>
      <div className={`row border-b ${classes.field}`}>
        <Icon name="search" />
        <input
          ref={input}
          data-autofocus
          className={`flex-1 min-w-0 border-0 bg-none ${classes.input}`}
          role="combobox"
          aria-label="Search or run a command"
          aria-expanded={lines.length > 0}
          aria-controls={listId}
          aria-activedescendant={selected && optionId(selected)}
          aria-autocomplete="list"
          autoComplete="off"
          spellCheck={false}
          placeholder="Search or run a command"
          value={query}
          onChange={(event) => {
            setQuery(event.currentTarget.value)
            setAt(0)
          }}
          onKeyDown={(event) => {
            if (event.nativeEvent.isComposing) return
            if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
              event.preventDefault()
              const step = event.key === 'ArrowDown' ? 1 : -1
              if (lines.length > 0) setAt((Math.min(at, lines.length - 1) + step + lines.length) % lines.length)
            } else if (event.key === 'Enter') {
              event.preventDefault()
              act(selected)
            }
          }}
        />
        <button type="button" className={`${classes.close} small dim`} onClick={onClose}>
          Esc<span className="visually-hidden"> closes</span>
        </button>
      </div>
      <div role="listbox" id={listId} aria-label="Results" className={`overflow-y-auto ${classes.list}`}>
        {sections.map((section) => (
          <div role="group" aria-label={section.title} key={section.title}>
            <p className={`${classes.heading} micro dim`} aria-hidden="true">
              {section.title}
            </p>
            {section.lines.map((line) => (
              <PaletteLine
                key={line.id}
                id={optionId(line)}
                line={line}
                selected={line === selected}
                onPoint={() => setAt(lines.indexOf(line))}
                onAct={() => act(line)}
              />
            ))}
          </div>
        ))}
      </div>
      <p role="status" className={lines.length > 0 ? 'visually-hidden' : 'p-14px mid'}>
        {lines.length > 0
          ? plural(lines.length, 'result')
          : asking
            ? 'Searching…'
            : `No results for “${query.trim()}”.`}
      </p>
    </>
  )
}

interface PaletteLineProps {
  id: string
  line: Line
  selected: boolean
  onPoint: () => void
  onAct: () => void
}

function PaletteLine({ id, line, selected, onPoint, onAct }: PaletteLineProps) {
  return (
    // The field keeps the focus and hears the arrows and Enter; the line itself answers to the pointer only.
    // eslint-disable-next-line jsx-a11y/click-events-have-key-events
    <div
      id={id}
      role="option"
      tabIndex={-1}
      aria-selected={selected}
      className={`flex items-center gap-10px pointer narrow-min-h-44px ${classes.line}`}
      onMouseMove={onPoint}
      onClick={onAct}
    >
      {'command' in line ? (
        <>
          <Icon name={line.command.icon ?? 'right'} />
          <span className="grow">{line.command.label}</span>
          {line.command.keys && <Key keys={line.command.keys} />}
        </>
      ) : (
        <>
          {line.found.number && <span className={`${classes.number} mono dim small`}>{line.found.number}</span>}
          <span className={`${classes.title} grow cut-text`}>{line.found.title}</span>
          {line.found.detail}
          {selected && (
            <span className="wide-only">
              <Key keys="Enter" />
            </span>
          )}
        </>
      )}
    </div>
  )
}
