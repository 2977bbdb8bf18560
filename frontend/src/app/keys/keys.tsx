import {
  createContext,
  type ReactNode,
  useCallback,
  useContext,
  useEffect,
  useLayoutEffect,
  useRef,
  useState,
  useSyncExternalStore,
} from 'react'

import { type Hotkey, KeyRegistry } from './registry'

const KEPT = 'soundlist-keys'

function keptOn(): boolean {
  try {
    return localStorage.getItem(KEPT) !== 'off'
  } catch {
    return true
  }
}

const Registry = createContext<KeyRegistry | null>(null)
const Scope = createContext<number | undefined>(undefined)

/** Listens for hotkeys; everything that registers one stands inside. */
export function KeysProvider({ children }: { children: ReactNode }) {
  const [registry] = useState(() => {
    const keyRegistry = new KeyRegistry()
    keyRegistry.setOn(keptOn())
    return keyRegistry
  })
  useEffect(() => registry.listen(window), [registry])
  useLayoutEffect(() => {
    document.documentElement.dataset.keys = registry.on ? 'on' : 'off'
  }, [registry])
  return <Registry value={registry}>{children}</Registry>
}

function useRegistry(): KeyRegistry {
  const registry = useContext(Registry)
  if (registry === null) throw new Error('KeysProvider is missing')
  return registry
}

/** Put hotkeys in force while the component is mounted. The functions may change at every render. */
export function useHotkeys(hotkeys: Hotkey[]): void {
  const registry = useRegistry()
  const scope = useContext(Scope)
  const latest = useRef(hotkeys)
  useLayoutEffect(() => {
    latest.current = hotkeys
  })
  const shape = hotkeys.map(({ keys, label, disabled }) => `${keys}\n${label}\n${String(disabled)}`).join('\n\n')
  // Before anything else can be pressed: a key that comes with the next sound must not judge the one before.
  useLayoutEffect(() => {
    const removers = latest.current.map((hotkey, index) =>
      registry.add(() => latest.current[index] ?? hotkey, scope ?? 0),
    )
    return () => {
      for (const remove of removers) remove()
    }
  }, [registry, scope, shape])
}

/** Everything inside hears its own hotkeys only, and the page below is deaf: for dialogs. */
export function KeyScope({ children }: { children: ReactNode }) {
  const registry = useRegistry()
  const [scope, setScope] = useState<number>()
  useEffect(() => {
    const opened = registry.openScope()
    setScope(opened.scope)
    return opened.close
  }, [registry])
  return scope === undefined ? null : <Scope value={scope}>{children}</Scope>
}

/** Every hotkey of the page, in the order it was registered. */
export function useListedHotkeys(): Hotkey[] {
  const registry = useRegistry()
  return useSyncExternalStore(registry.subscribe, registry.listed)
}

/** Whether single keys are on, and the switch for it, kept in the browser. */
export function useKeysSwitch(): [boolean, (on: boolean) => void] {
  const registry = useRegistry()
  const on = useSyncExternalStore(registry.subscribe, () => registry.on)
  const set = useCallback(
    (isOn: boolean) => {
      registry.setOn(isOn)
      document.documentElement.dataset.keys = isOn ? 'on' : 'off'
      try {
        localStorage.setItem(KEPT, isOn ? 'on' : 'off')
      } catch {
        // A browser that keeps nothing still switches for this page.
      }
    },
    [registry],
  )
  return [on, set]
}
