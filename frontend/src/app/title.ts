import { createContext, useContext, useEffect } from 'react'

/** The name of the project in hand, set by the shell. */
export const ProjectName = createContext<string | undefined>(undefined)

/** Name the page in the browser's title: "Sound list · Shield Wing · Soundlist". */
export function useTitle(page: string): void {
  const project = useContext(ProjectName)
  useEffect(() => {
    document.title = [...new Set([page, project, 'Soundlist'])].filter(Boolean).join(' · ')
  }, [page, project])
}
