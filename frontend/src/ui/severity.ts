import type { IconName } from './Icon'

/** How grave a finding is: it returns the file, warns, or asks for an ear. */
export type Severity = 'error' | 'warning' | 'information'

interface Look {
  tone: 'bad' | 'warn' | 'review'
  icon: IconName
  /** Read out before the finding. */
  label: string
}

export const SEVERITY_LOOK: Record<Severity, Look> = {
  error: { tone: 'bad', icon: 'back', label: 'Error: ' },
  warning: { tone: 'warn', icon: 'triangle', label: 'Warning: ' },
  information: { tone: 'review', icon: 'headphones', label: 'To listen to: ' },
}
