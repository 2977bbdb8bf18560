import { type ComponentType, useEffect, useEffectEvent, useState } from 'react'

const nothing = () => undefined

/** A component that is loaded once it is wanted; null until then. `onFail` is called where it cannot be loaded. */
export function useLazy<Props>(
  load: () => Promise<ComponentType<Props>>,
  isWanted: boolean,
  onFail: () => void = nothing,
): ComponentType<Props> | null {
  const [loaded, setLoaded] = useState<ComponentType<Props> | null>(null)
  const failed = useEffectEvent(onFail)
  useEffect(() => {
    if (!isWanted || loaded !== null) return
    load().then(
      (part) => setLoaded(() => part),
      () => failed(),
    )
  }, [load, isWanted, loaded])
  return loaded
}
