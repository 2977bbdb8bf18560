export { HotkeyButton } from './HotkeyButton'
export { KeyScope, KeysProvider, useHotkeys, useKeysSwitch, useListedHotkeys } from './keys'
export type { Hotkey } from './registry'
