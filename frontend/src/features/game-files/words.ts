import { bytes, channels, figure, sampleFormat, plural, rate } from '@/ui/format'

import type { Batch, BatchSizes, Changes, Handoff, Memory, Target } from './api'

/** "48 kHz, 16 bit, mono". */
export function formatOf({ sample_rate_hz, bit_depth, encoding, quality, channels: count }: Target): string {
  const depth = sampleFormat(bit_depth, encoding, quality)
  return [rate(sample_rate_hz), depth, count === 'master' ? 'same as master' : channels(count)].join(', ')
}

/** How the game keeps it: "resident, codec 4 : 1". */
export const keptAs = ({ streamed, codec_ratio }: Target): string =>
  [
    streamed ? 'streamed from disk' : 'resident',
    codec_ratio > 1 ? `codec ${figure(codec_ratio, codec_ratio % 1 ? 1 : 0)} : 1` : 'PCM',
  ].join(', ')

/** "4.0 MB, 1.0 MB under", "over by", or without a budget the size alone. */
export function roomOf({ memory_bytes, over_bytes }: Memory): string {
  if (over_bytes === null) return `${bytes(memory_bytes)}, no budget`
  if (over_bytes > 0) return `${bytes(memory_bytes)}, over by ${bytes(over_bytes)}`
  return `${bytes(memory_bytes)}, ${bytes(-over_bytes)} under`
}

const done = ({ made, kept, refused, left }: Batch): number => made + kept + refused + left

/** What happened to a batch so far. */
export function progressOf(batch: Batch): string {
  if (batch.state === 'planning') return 'being planned'
  const parts = [
    batch.made > 0 && `${figure(batch.made)} rendered`,
    batch.kept > 0 && `${figure(batch.kept)} unchanged`,
    batch.refused > 0 && `${figure(batch.refused)} refused`,
    batch.left > 0 && `${figure(batch.left)} skipped`,
    batch.waiting > 0 && `${figure(batch.waiting)} ${batch.state === 'running' ? 'to render' : 'not rendered'}`,
  ].filter(Boolean)
  return `${figure(done(batch))} of ${plural(batch.files, 'file')}${parts.length > 0 ? `: ${parts.join(', ')}` : ''}`
}

/** "2 new, 1 changed, 1 gone, 40 as before". */
export function changesInWords({ since, changed, gone, same, ...counts }: Changes): string {
  if (since === null) return 'first pack for this target'
  const parts = [
    counts.new > 0 && `${figure(counts.new)} new`,
    changed > 0 && `${figure(changed)} changed`,
    gone > 0 && `${figure(gone)} removed`,
    same > 0 && `${figure(same)} unchanged`,
  ].filter(Boolean)
  return `since pack ${since}: ${parts.join(', ') || 'nothing'}`
}

/** What engines are called, and the import files that each gets in a pack. */
export const HANDOFFS: Record<Handoff, { label: string; does: string }> = {
  none: { label: 'None', does: 'Sounds and documentation only.' },
  wwise: { label: 'Wwise', does: 'Tables for the tab-delimited import: containers, loops, notes and new events.' },
  fmod: { label: 'FMOD Studio', does: 'A script for the Scripts menu that creates events by category.' },
  unity: { label: 'Unity', does: 'Import settings by category, and a menu item that creates a prefab for each event.' },
  unreal: { label: 'Unreal', does: 'An editor script that imports what changed and creates sound cues.' },
  godot: { label: 'Godot', does: 'Import files beside the sounds, and a randomizer for each set.' },
}

export const signed = (count: number): string =>
  count === 0 ? 'the same' : `${count > 0 ? '+' : '−'}${bytes(Math.abs(count))}`

export const sizeOf = (count: number): string => (count === 0 ? 'none' : bytes(count))

/** The bytes of each target's game files before and after, all categories together. */
export function totalsOf(sizes: readonly BatchSizes[]): { target: string; before: number; after: number }[] {
  const totals = new Map<string, { target: string; before: number; after: number }>()
  for (const { target, before_bytes, after_bytes } of sizes) {
    const { before, after } = totals.get(target) ?? { before: 0, after: 0 }
    totals.set(target, { target, before: before + before_bytes, after: after + after_bytes })
  }
  return [...totals.values()]
}
