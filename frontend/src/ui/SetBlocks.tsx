import { countOf } from './format'
import classes from './SetBlocks.module.css'
import type { Tone } from './StatusBadge'

export interface SetBlock {
  tone: Tone
  /** The odd one of its set is drawn taller. */
  odd?: boolean
}

interface SetBlocksProps {
  blocks: SetBlock[]
  /** As text next to the blocks, "4 of 4" where nothing else is said. */
  words?: string
}

const LEFT: Tone = 'idle'

/** A set: one block a variation, filled by its state, and the count in words. */
export function SetBlocks({ blocks, words }: SetBlocksProps) {
  const here = blocks.filter(({ tone }) => tone !== LEFT).length
  return (
    <span className="inline-flex items-center gap-6px nowrap">
      <span className={`inline-flex items-center gap-3px ${classes.blocks}`} aria-hidden="true">
        {blocks.map(({ tone, odd }, index) => (
          <i key={index} className={`tone-${tone} ${tone === LEFT ? '' : classes.full}`} data-odd={odd || undefined} />
        ))}
      </span>
      <span className="small mid">{words ?? countOf(here, blocks.length)}</span>
    </span>
  )
}
