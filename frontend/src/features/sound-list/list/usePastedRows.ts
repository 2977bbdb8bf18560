import { useEffect } from 'react'

import { EMPTY_SHEET, keepSheet } from '../import/pasted'

/** Rows pasted anywhere on the page, but into no field, are kept for the import, which opens. */
export function usePastedRows(projectId: string, mayEdit: boolean, toImport: () => void): void {
  useEffect(() => {
    if (!mayEdit) return
    const paste = (event: ClipboardEvent) => {
      if (event.target instanceof HTMLElement && event.target.closest('input, textarea, select, [contenteditable]'))
        return
      const text = event.clipboardData?.getData('text/plain') ?? ''
      if (text.trim() === '') return
      event.preventDefault()
      keepSheet(projectId, { ...EMPTY_SHEET, text }, true)
      toImport()
    }
    window.addEventListener('paste', paste)
    return () => window.removeEventListener('paste', paste)
  }, [mayEdit, projectId, toImport])
}
