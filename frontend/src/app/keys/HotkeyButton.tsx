import { Button, type ButtonProps } from '@/ui/Button'

import { useHotkeys } from './keys'

export interface HotkeyButtonProps extends Omit<ButtonProps, 'keys' | 'onClick' | 'aria-label'> {
  keys: string
  /** What it does, in the sheet of all keys. */
  keyLabel: string
  keyGroup?: string
  onPress: () => void
}

/** A button that shows its key and answers to it. */
export function HotkeyButton({ keys, keyLabel, keyGroup, onPress, disabled, ...rest }: HotkeyButtonProps) {
  useHotkeys([{ keys, label: keyLabel, group: keyGroup, run: onPress, disabled }])
  return <Button {...rest} keys={keys} disabled={disabled} onClick={onPress} />
}
