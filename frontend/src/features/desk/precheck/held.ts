import type { Picked } from '@/uploads'

import type { Finding } from '@/precheck/findings'

/** What is known of a file by its name and its bytes. */
export interface Look {
  /** The number and name of the cue that it is for, once its name says so. */
  cue: string
  /** What the list calls it; null where its name is right, or no cue is likely. */
  listName: string | null
  findings: Finding[]
}

export interface Candidate {
  picked: Picked
  /** The cue that it was dropped on. */
  cueId: string | null
}

/** A file that waits for a decision: it would come back, or its name does not say which cue it is for. */
export interface HeldFile extends Candidate, Look {
  id: number
  /** The name in the field; it counts once the file is renamed. */
  wanted: string
  /** What it was called when it was dropped; null while it has that name. */
  firstName: string | null
}

export interface PrecheckState {
  held: readonly HeldFile[]
  /** The files of each renaming as they were before it, the last one last. */
  renames: readonly (readonly HeldFile[])[]
  isRenaming: boolean
  /** Files that were judged, of those that were dropped since all were. */
  judged: number
  dropped: number
  /** Sounds that passed and were sent since then. */
  passed: number
  /** What is checked before the upload, in words of the server. */
  labels: readonly string[]
}
