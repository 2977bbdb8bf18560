import type { ReactNode } from 'react'

export interface ShellProject {
  id: string
  name: string
  /** Made to look around in, and deleted by one press. */
  isSample?: boolean
}

/** What the top bar shows of the current person. */
export interface ShellData {
  /** Not signed in: null. */
  person: { name: string; role: string; picture?: string | null } | null
  /** Designers have Deliveries; everyone of the studio has Today. */
  side: 'studio' | 'designer'
  project: ShellProject | null
  /** The project is closed to this person until its NDA is agreed; then all but its contracts is. */
  ndaOpen: boolean
  /** Speaks for a side of the project: its contracts and money are this person's to see. */
  speaks: boolean
  /** The server has contracts, money and hiring. */
  hasContracts: boolean
  /** A producer of the project's studio. */
  isProducer: boolean
  /** In the studio to put sounds into the game, and for nothing else. */
  isImplementer: boolean
  projects: ShellProject[]
  /** What waits for this person, shown next to the tab where it is done. */
  counts: { today?: number; desk?: number; review?: number | string; contract?: number }
  /** How many notices the person has not read, as the bell shows it; missing where all is read. */
  unread?: string
  /** Whether jobs and storage are this person's to see: a producer's, or an operator. */
  operates: boolean
  signOut: () => void
  /** Signs in again in place, where the session has ended. */
  signInAgain?: ReactNode
  /** A row of the menu that changes who one is: in the demo only. */
  switcher?: ReactNode
}

/** The current person, as the account feature passes it to the shell through the router's context. */
export interface Session {
  useShell: () => ShellData
  /** Asks who is signed in, before anything needs the answer. */
  prefetchPerson?: () => void
  /** Called before every page of the shell; throws a redirect to sign-in if not signed in. */
  ensureSignedIn: (href: string) => Promise<void>
}

/** Shown while not signed in. */
export const NOBODY: ShellData = {
  person: null,
  side: 'studio',
  project: null,
  ndaOpen: false,
  speaks: false,
  hasContracts: true,
  isProducer: false,
  isImplementer: false,
  projects: [],
  counts: {},
  operates: false,
  signOut: () => undefined,
}

/** The session of a page that asks for no one. */
export const guestSession: Session = { useShell: () => NOBODY, ensureSignedIn: () => Promise.resolve() }
