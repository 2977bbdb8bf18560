import { type Hotkey, useHotkeys } from '@/app/keys'
import { useCommands } from '@/app/palette'

import type { PanelKind } from './CuePanel'
import type { CueRow } from '../rows'

const LIST = 'List'

/** What the keys and the palette do on the sound list. */
export interface ListActs {
  selected: CueRow | undefined
  mayEdit: boolean
  add: () => void
  addSought: () => void
  toImport: () => void
  openCue: (row: CueRow) => void
  openPanel: (kind: PanelKind) => void
  changeNeed: (row: CueRow) => void
  pick: (id: string, extend: boolean) => void
  play: (row: CueRow) => void
  step: (by: 1 | -1) => void
  toFilter: () => void
  toStates: () => void
  escape: () => void
}

/** The keys of the sound list, and its commands in the palette. */
export function useListKeys(acts: ListActs): void {
  const { selected, mayEdit, add, addSought, toImport, openCue, openPanel, pick, play, step, escape } = acts
  const isCut = selected?.status === 'cut'
  const editing: Hotkey[] = [
    { keys: 'n', label: 'Add a cue', group: LIST, run: addSought },
    { keys: 'e', label: 'Edit', group: LIST, run: () => openPanel('edit'), disabled: !selected || isCut },
    {
      keys: 'c',
      label: 'Answer what is unclear',
      group: LIST,
      run: () => openPanel('clarify'),
      disabled: !selected || selected.unclear.length === 0,
    },
    {
      keys: 'm',
      label: 'Change need',
      group: LIST,
      run: () => selected && acts.changeNeed(selected),
      disabled: !selected || isCut,
    },
    {
      keys: 'v',
      label: 'Record a placeholder',
      group: LIST,
      run: () => openPanel('say'),
      disabled: !selected || isCut,
    },
    { keys: 'i', label: 'Paste or import', group: LIST, run: toImport },
    { keys: 'x', label: 'Select', group: LIST, run: () => selected && pick(selected.id, false), disabled: !selected },
    {
      keys: 'shift+x',
      label: 'Select range to here',
      group: LIST,
      run: () => selected && pick(selected.id, true),
      disabled: !selected,
    },
  ]
  useHotkeys([
    { keys: 'Escape', label: 'Close or clear filters', group: LIST, run: escape },
    { keys: 'j', label: 'Next', group: LIST, run: () => step(1), repeats: true },
    { keys: 'k', label: 'Previous', group: LIST, run: () => step(-1), repeats: true },
    { keys: 'Enter', label: 'Open', group: LIST, run: () => selected && openCue(selected), disabled: !selected },
    {
      keys: 'Space',
      label: 'Play',
      group: LIST,
      run: () => selected && play(selected),
      disabled: !selected?.previewUrl,
    },
    { keys: '/', label: 'Filter', group: LIST, run: acts.toFilter },
    { keys: 'f', label: 'Filter by state', group: LIST, run: acts.toStates },
    { keys: 'q', label: 'Ask a question', group: LIST, run: () => openPanel('ask'), disabled: !selected },
    ...(mayEdit ? editing : []),
  ])
  useCommands([
    ...(mayEdit
      ? [
          { id: 'add-cue', label: 'Add a cue', icon: 'plus' as const, keys: 'n', run: add },
          { id: 'import', label: 'Paste or import', icon: 'upload' as const, keys: 'i', run: toImport },
        ]
      : []),
    ...(selected && mayEdit && !isCut
      ? [
          {
            id: 'edit-cue',
            label: `Edit ${selected.cue.name}`,
            icon: 'pencil' as const,
            keys: 'e',
            run: () => openPanel('edit'),
          },
        ]
      : []),
    ...(selected
      ? [
          {
            id: 'ask-cue',
            label: `Ask about ${selected.cue.name}`,
            icon: 'question' as const,
            keys: 'q',
            run: () => openPanel('ask'),
          },
        ]
      : []),
  ])
}
