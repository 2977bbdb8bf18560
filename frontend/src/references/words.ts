import { bytes, length } from '@/ui/format'
import type { IconName } from '@/ui/Icon'

import type { Reference, ReferenceVersion } from './api'

type Kind = ReferenceVersion['kind']

const NAMES: Record<Kind, string> = {
  picture: 'Picture',
  pdf: 'PDF',
  text: 'Text',
  video: 'Clip',
  audio: 'Sound',
  file: 'File',
  link: 'Link',
}
const ICONS: Record<Kind, IconName> = {
  picture: 'file',
  pdf: 'file',
  text: 'lines',
  video: 'play',
  audio: 'play',
  file: 'file',
  link: 'right',
}

export const kindName = (kind: Kind): string => NAMES[kind]
export const kindIcon = (kind: Kind): IconName => ICONS[kind]

/** Its caption, or what its file is called. */
export const titleOf = ({ caption, version }: Reference): string => caption || version.file_name

/** An instant of a clip: 0:41.2. */
function instant(s: number): string {
  const tenths = Math.round(s * 10)
  return `${Math.floor(tenths / 600)}:${((tenths % 600) / 10).toFixed(1).padStart(4, '0')}`
}

/** The part that is meant: "0:41.2–0:43.0", or "from 0:41.2". */
function partWords({ start_s: start, end_s: end }: Pick<Reference, 'start_s' | 'end_s'>): string {
  if (start === null) return ''
  return end === null ? `from ${instant(start)}` : `${instant(start)}–${instant(end)}, ${length(end - start)}`
}

/** What it is, in one line: "Clip, 0:41.2–0:43.0, 1.80 s, 12 MB". */
export function factsOf(reference: Reference): string {
  const { version } = reference
  const host = version.kind === 'link' ? version.file_name : ''
  const size = version.file_bytes === null ? '' : bytes(version.file_bytes)
  return [kindName(version.kind), host, partWords(reference), size].filter(Boolean).join(', ')
}

/** The part that is meant, as browsers read it at the end of an address. */
export function fragmentOf({ start_s: start, end_s: end }: Pick<Reference, 'start_s' | 'end_s'>): string {
  if (start === null) return ''
  return end === null ? `#t=${start}` : `#t=${start},${end}`
}
