import { type MantineColorScheme, useComputedColorScheme, useMantineColorScheme } from '@mantine/core'

export interface Scheme {
  /** What was chosen: light, dark, or auto, which follows the system. */
  chosen: MantineColorScheme
  /** The other one than is seen now. */
  next: 'light' | 'dark'
  set: (scheme: MantineColorScheme) => void
}

export function useScheme(): Scheme {
  const { colorScheme, setColorScheme } = useMantineColorScheme()
  const seen = useComputedColorScheme('light', { getInitialValueInEffect: false })
  return { chosen: colorScheme, next: seen === 'dark' ? 'light' : 'dark', set: setColorScheme }
}
