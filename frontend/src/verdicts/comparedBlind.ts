import { useEffect } from 'react'

let cueOfBlind: string | undefined

/** The id of the cue whose versions are compared blind on this page, if any are. */
export const comparedBlind = (): string | undefined => cueOfBlind

/** Say that versions of a cue are compared blind while the component is mounted; undefined where they are not. */
export function useComparedBlind(cueId: string | undefined): void {
  useEffect(() => {
    cueOfBlind = cueId
    return () => {
      cueOfBlind = undefined
    }
  }, [cueId])
}
