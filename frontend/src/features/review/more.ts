import { type Hotkey, useHotkeys } from '@/app/keys'

/** A line of the More menu. */
export interface MoreItem {
  label: string
  /** At the end of the line, where no key does it. */
  note?: string
  /** The key that does the same while the menu is closed. */
  keys?: string
  /** What the list of keys calls it. */
  keyLabel?: string
  /** On or off; an item without it does something once. */
  checked?: boolean
  disabled?: boolean
  run: () => void
}

export interface MoreGroup {
  title?: string
  /** One of them is chosen. */
  isChoice?: boolean
  /** A menu of its own behind one line. */
  isFolded?: boolean
  items: readonly MoreItem[]
}

/** What is true of nothing is left out. */
export const present = <Item>(items: readonly (Item | false | null | undefined)[]): Item[] =>
  items.filter((item): item is Item => Boolean(item))

/** The keys of the More menu, which act while it is closed too. */
export function useMoreKeys(groups: readonly MoreGroup[]): void {
  useHotkeys(
    groups
      .flatMap(({ items }) => items)
      .flatMap(({ keys, keyLabel, label, disabled, run }): Hotkey[] =>
        keys === undefined ? [] : [{ keys, label: keyLabel ?? label, group: 'Review', run, disabled }],
      ),
  )
}
